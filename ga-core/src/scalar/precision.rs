//! What depends on the precision of a number: the coefficients of its polynomials and where its
//! functions reach their ends.
//!
//! The polynomials are minimax approximations by the exchange algorithm of Remez, computed with
//! sixty digits and rounded (`tests/data/coefficients.py`). The error that stands with each is the
//! largest one of the function that is made of it, relative to its size, before the rounding of
//! its evaluation.

mod double;
mod single;

use core::ops::Neg;

use super::elementary::Elementary;
use super::lanes::Lanes;

/// A precision of floating-point numbers: `f32` or `f64`.
pub trait Precision: Elementary + Lanes<Float = Self, Mask = bool> + Neg<Output = Self> {
    /// A value given in double precision, rounded.
    fn rounded(value: f64) -> Self;

    /// A number so large that the sum with it has no digits below one, and an even last one for
    /// even numbers: adding and subtracting it rounds to integers.
    const ROUNDING: Self;
    /// The largest finite number.
    const LARGEST: Self;
    /// The smallest normal number.
    const SMALLEST: Self;
    /// A power of two that makes every smaller number normal, and its exponent.
    const NORMALISING: (Self, Self);
    /// A number whose exponential is infinite, and that of its opposite zero.
    const ENDLESS: Self;
    /// ln 2 in two parts: multiples of the first are exact.
    const LN_2: [Self; 2];
    /// π/4 in two parts: the first four multiples of the first are exact.
    const QUARTER_PI: [Self; 2];
    /// π/2 in parts: up to [`MOST_TURNS`](Precision::MOST_TURNS) times all but the last are exact.
    const HALF_PI: &'static [Self];
    /// How many quarters of a turn are reduced with [`HALF_PI`](Precision::HALF_PI).
    const MOST_TURNS: Self;

    /// (sin r − r)/r³ in r², for |r| ≤ π/4.
    const SINE: &'static [Self];
    /// (cos r − 1 + r²/2)/r⁴ in r², for |r| ≤ π/4.
    const COSINE: &'static [Self];
    /// (arctan t − t)/t³ in t², for |t| ≤ √2 − 1.
    const ARCTANGENT: &'static [Self];
    /// (eʳ − 1 − r)/r² in r, for |r| ≤ ln 2/2.
    const EXPONENTIAL: &'static [Self];
    /// (2 artanh t − 2t)/t³ in t², for |t| ≤ 3 − 2√2.
    const LOGARITHM: &'static [Self];
    /// (S(a) − 1)/a in a, for −π² ≤ a ≤ 1, with S(a) = sinh √a/√a.
    const SINHC: &'static [Self];
    /// S′(a) in a, for −π² ≤ a ≤ 1; the error is that of 2a S′(a).
    const SINHC_SLOPE: &'static [Self];
    /// (f(c) − 1)/x in x = 1 − c, for 0 ≤ c ≤ 9/8, with f(cos θ) = θ/sin θ.
    const ARC: &'static [Self];
}
