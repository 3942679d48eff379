//! Coefficients of single precision.

use super::Precision;

impl Precision for f32 {
    #[inline(always)]
    fn rounded(value: f64) -> f32 {
        value as f32
    }

    const ROUNDING: f32 = 12_582_912.0;
    const LARGEST: f32 = f32::MAX;
    const SMALLEST: f32 = f32::MIN_POSITIVE;
    const NORMALISING: (f32, f32) = (33_554_432.0, 25.0);
    const ENDLESS: f32 = 120.0;
    const LN_2: [f32; 2] = [0.69311523, 3.1946183e-5];
    const QUARTER_PI: [f32; 2] = [0.78515625, 0.0002419134];
    const HALF_PI: &'static [f32] = &[1.5703125, 0.0004837513, 7.5495336e-8, 2.563344e-12];
    const MOST_TURNS: f32 = 4096.0;

    /// Error 6e-9.
    const SINE: &'static [Self] = &[-0.16666655, 0.008332176, -0.00019516978];

    /// Error 5e-10.
    const COSINE: &'static [Self] = &[0.041666646, -0.0013887364, 2.4438094e-5];

    /// Error 3e-9.
    const ARCTANGENT: &'static [Self] =
        &[-0.33333316, 0.19998483, -0.1424374, 0.10595143, -0.06081161];

    /// Error 5e-9.
    const EXPONENTIAL: &'static [Self] = &[0.5, 0.16666517, 0.041666202, 0.008369088, 0.0013950849];

    /// Error 2e-9.
    const LOGARITHM: &'static [Self] = &[0.6666678, 0.3997708, 0.2988519];

    /// Error 1e-8.
    const SINHC: &'static [Self] = &[
        0.16666667,
        0.008333333,
        0.00019841014,
        2.754492e-6,
        2.4807477e-8,
        1.3870792e-10,
    ];

    /// Error 3e-8.
    const SINHC_SLOPE: &'static [Self] = &[
        0.16666669,
        0.016666666,
        0.0005952209,
        1.1014377e-5,
        1.2357171e-7,
        8.119133e-10,
    ];

    /// Error 3e-8.
    const ARC: &'static [Self] = &[
        0.3333336,
        0.1333392,
        0.057084452,
        0.025204634,
        0.014695491,
        -0.006600416,
        0.023734147,
        -0.017847423,
        0.007852597,
    ];
}
