//! Elementary functions against those of the standard library: dense sweeps, random bits and the
//! edges; each lane against the number alone.

use ga_core::{Lanes, Precision, Real};
use rand::{RngExt, SeedableRng};

/// The distance of two numbers in units in the last place of the larger one; zero for the same
/// infinity, for what is not a number, and for zeros of one sign.
fn units(found: f64, expected: f64, epsilon: f64, smallest: f64) -> f64 {
    if found.is_nan() || expected.is_nan() || found.is_infinite() || expected.is_infinite() {
        let same = found == expected || found.is_nan() && expected.is_nan();
        return if same { 0.0 } else { f64::INFINITY };
    }
    if found == 0.0 && expected == 0.0 && found.is_sign_negative() != expected.is_sign_negative() {
        return f64::INFINITY;
    }
    let size = expected.abs().max(smallest);
    let ulp = epsilon * 2.0_f64.powi(size.log2().floor() as i32);
    (found - expected).abs() / ulp
}

const EDGES: [f64; 26] = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    0.5,
    2.0,
    core::f64::consts::PI,
    core::f64::consts::FRAC_PI_2,
    core::f64::consts::FRAC_PI_4,
    -core::f64::consts::LN_2,
    1e-300,
    1e300,
    -1e300,
    5e-324,
    -5e-324,
    f64::MIN_POSITIVE,
    f64::MAX,
    f64::MIN,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::NAN,
    709.782712893384,
    -745.1332191019411,
    88.72283,
    1e-45,
    1e22,
];

/// Numbers of every size, and dense ones of the usual sizes.
fn samples() -> Vec<f64> {
    let mut random = rand::rngs::StdRng::seed_from_u64(31);
    let bits = (0..20_000).map(|_| f64::from_bits(random.random()));
    let sweep = (-40_000..=40_000).map(|i| f64::from(i) / 1024.0);
    let turns = (-2000..2000).flat_map(|i| {
        let x = f64::from(i) * core::f64::consts::FRAC_PI_4;
        [x, x.next_up(), x.next_down(), f64::from(x as f32)]
    });
    let small = (0..2000).map(|i| 2.0_f64.powf(-f64::from(i) / 2.0));
    let ones = (-3000..3000).map(|i| 1.0 + f64::from(i) * f64::from(i).abs() * 3e-9);
    let far = (-3000..3000).map(|i| f64::from(i) * 0.37);
    let mut all: Vec<f64> = EDGES.into();
    all.extend(
        sweep
            .chain(bits)
            .chain(turns)
            .chain(small)
            .chain(ones)
            .chain(far),
    );
    all
}

type Function = (&'static str, fn(f64) -> f64, fn(f32) -> f32, fn(f64) -> f64);

const FUNCTIONS: [Function; 5] = [
    ("exp", Real::exp, Real::exp, f64::exp),
    ("ln", Real::ln, Real::ln, f64::ln),
    (
        "sin",
        |x| Real::sin_cos(x).0,
        |x| Real::sin_cos(x).0,
        f64::sin,
    ),
    (
        "cos",
        |x| Real::sin_cos(x).1,
        |x| Real::sin_cos(x).1,
        f64::cos,
    ),
    ("sqrt", Real::sqrt, Real::sqrt, f64::sqrt),
];

fn judge(name: &str, worst: (f64, f64), allowed: f64) {
    println!("{name}: {:.2} units at {:e}", worst.0, worst.1);
    assert!(worst.0 <= allowed, "{name}: {} at {:e}", worst.0, worst.1);
}

#[test]
fn functions_of_one_number() {
    for (name, double, single, expected) in FUNCTIONS {
        let mut worst = [(0.0, 0.0); 2];
        for x in samples() {
            let error = units(double(x), expected(x), f64::EPSILON, f64::MIN_POSITIVE);
            if error > worst[0].0 {
                worst[0] = (error, x);
            }
            let x = x as f32;
            let rounded = expected(x.into()) as f32;
            let exact = match rounded.is_finite() {
                true => expected(x.into()),
                false => rounded.into(),
            };
            let (epsilon, smallest) = (f32::EPSILON.into(), f32::MIN_POSITIVE.into());
            let error = units(single(x).into(), exact, epsilon, smallest);
            if error > worst[1].0 {
                worst[1] = (error, x.into());
            }
        }
        judge(name, worst[0], 1.6);
        judge(name, worst[1], 1.6);
    }
}

#[test]
fn angles_of_points() {
    let mut random = rand::rngs::StdRng::seed_from_u64(7);
    let edges = EDGES
        .into_iter()
        .flat_map(|y| EDGES.into_iter().map(move |x| (y, x)));
    let around = (0..50_000).map(|i| {
        let (sin, cos) = (f64::from(i) * 1.3e-4).sin_cos();
        (sin, cos)
    });
    let bits: Vec<(f64, f64)> = (0..20_000)
        .map(|_| {
            (
                f64::from_bits(random.random()),
                f64::from_bits(random.random()),
            )
        })
        .collect();
    let mut worst = [(0.0, 0.0); 2];
    for (y, x) in edges.chain(around).chain(bits) {
        let expected = y.atan2(x);
        let error = units(Real::atan2(y, x), expected, f64::EPSILON, f64::MIN_POSITIVE);
        if error > worst[0].0 {
            worst[0] = (error, expected);
        }
        let (y, x) = (y as f32, x as f32);
        let expected = f64::from(y).atan2(x.into());
        let found = f64::from(Real::atan2(y, x));
        let error = units(
            found,
            expected,
            f32::EPSILON.into(),
            f32::MIN_POSITIVE.into(),
        );
        if error > worst[1].0 {
            worst[1] = (error, expected);
        }
    }
    judge("atan2", worst[0], 2.2);
    judge("atan2 of f32", worst[1], 2.2);
}

/// C, S and S′ near and far, in single precision against double, and S′ against its definition.
#[test]
fn functions_of_the_square_of_a_bivector() {
    for i in -40_000..8_000 {
        let a = f64::from(i as f32 * 0.01);
        let size = 1.0 + a.abs().sqrt();
        let (cosh, sinhc, slope) = a.cosh_sinhc_slope();
        let (direct_cosh, direct_sinhc) = a.cosh_sinhc();
        let close = |found: f64, expected: f64, epsilon: f64| {
            let bound = 3.0 * epsilon * size * expected.abs().max(1.0);
            assert!(
                (found - expected).abs() <= bound,
                "{found} {expected} at {a}"
            );
        };
        close(cosh, direct_cosh, f64::EPSILON);
        close(sinhc, direct_sinhc, f64::EPSILON);
        if a.abs() > 0.5 {
            close(slope, (cosh - sinhc) / (2.0 * a), 2.0 * f64::EPSILON);
        }
        let (single_cosh, single_sinhc, single_slope) = (a as f32).cosh_sinhc_slope();
        close(single_cosh.into(), cosh, f32::EPSILON.into());
        close(single_sinhc.into(), sinhc, f32::EPSILON.into());
        close(single_slope.into(), slope, f32::EPSILON.into());
    }
    assert!(f64::NAN.cosh_sinhc_slope().2.is_nan());
    // Beyond what polynomials reduce; the root of these squares is exact.
    for angle in [
        3.0e6,
        1.0e7,
        9.0e7,
        94_906_000.0,
        2.0_f64.powi(60),
        2.0_f64.powi(300),
    ] {
        let (cosh, sinhc) = (-angle * angle).cosh_sinhc();
        assert!((cosh - angle.cos()).abs() < 1e-15, "{angle}");
        assert!((sinhc * angle - angle.sin()).abs() < 1e-15, "{angle}");
    }
    for angle in [2.0e4_f32, 2.0_f32.powi(20), 2.0_f32.powi(50)] {
        let (cosh, sinhc) = (-angle * angle).cosh_sinhc();
        let (sin, cos) = f64::from((angle * angle).sqrt()).sin_cos();
        assert!((f64::from(cosh) - cos).abs() < 3e-7, "{angle}");
        assert!((f64::from(sinhc * angle) - sin).abs() < 3e-7, "{angle}");
    }
}

/// Where the polynomials end and where there is nothing to reduce: on both sides, and beyond all
/// numbers.
#[test]
fn ends_of_the_functions_of_squares() {
    let expected = |a: f64| {
        let root = a.abs().sqrt();
        match (a < 0.0, root < 1e-100) {
            (_, true) => (1.0, 1.0),
            (true, _) => (root.cos(), root.sin() / root),
            (false, _) => (root.cosh(), root.sinh() / root),
        }
    };
    let turn = core::f64::consts::PI.powi(2);
    for end in [
        -9.8696_f64,
        -turn,
        -4.0 * turn,
        0.0,
        -0.0,
        1.0,
        5e-324,
        -5e-324,
    ] {
        for a in [end, end.next_up(), end.next_down()] {
            let ((cosh, sinhc), (expected_cosh, expected_sinhc)) = (a.cosh_sinhc(), expected(a));
            assert!((cosh - expected_cosh).abs() < 2e-15, "{cosh} at {a:e}");
            assert!((sinhc - expected_sinhc).abs() < 1e-15, "{sinhc} at {a:e}");
        }
        let a = end as f32;
        for a in [a, a.next_up(), a.next_down()] {
            let ((cosh, sinhc), (expected_cosh, expected_sinhc)) =
                (a.cosh_sinhc(), expected(a.into()));
            assert!(
                (f64::from(cosh) - expected_cosh).abs() < 1e-6,
                "{cosh} at {a:e}"
            );
            assert!(
                (f64::from(sinhc) - expected_sinhc).abs() < 5e-7,
                "{sinhc} at {a:e}"
            );
        }
    }
    for a in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let (cosh, sinhc) = a.cosh_sinhc();
        assert!(!cosh.is_finite(), "{a}");
        assert!(!sinhc.is_finite() || sinhc == 0.0, "{a}");
    }
}

/// The cosines at which another way of taking logarithms begins, and what has none.
#[test]
fn ends_of_the_factors_of_logarithms() {
    for end in [1.0_f64, 1.125, 0.5, 0.0, -0.0, -0.5, -0.999_999] {
        for cosine in [end, end.next_up(), end.next_down()] {
            let square = cosine * cosine - 1.0;
            let root = f64::abs(square).sqrt();
            let expected = match (square < 0.0, root < 1e-7) {
                (_, true) => 1.0,
                (true, _) => root.atan2(cosine) / root,
                (false, _) => f64::ln(cosine + root) / root,
            };
            let (factor, slope) = cosine.log_factor_slope(square).unwrap();
            assert!(
                (factor - expected).abs() <= 2e-15 * expected,
                "{factor} at {cosine}"
            );
            assert!(slope.is_finite(), "{cosine}");
            let alone = cosine.log_factor(square).unwrap();
            assert!(
                (alone - expected).abs() <= 2e-15 * expected,
                "{alone} at {cosine}"
            );
        }
    }
    let nothing = [
        (-1.0, 0.0),
        (-1.5, 1.25),
        (0.0, 0.0),
        (0.5, 0.5),
        (2.0, -0.5),
        (f64::NAN, -1.0),
        (0.5, f64::NAN),
        (f64::INFINITY, f64::INFINITY),
        (0.0, f64::NEG_INFINITY),
    ];
    for (cosine, square) in nothing {
        assert_eq!(cosine.log_factor(square), None, "{cosine} {square}");
        assert_eq!(cosine.log_factor_slope(square), None, "{cosine} {square}");
    }
}

/// θ/sin θ and its slope by cos θ, of turns up to near π and of rapidities.
#[test]
fn factors_of_logarithms() {
    for i in 1..3140 {
        let angle = f64::from(i) * 1e-3;
        let (sin, cos) = angle.sin_cos();
        let (factor, slope) = cos.log_factor_slope(-sin * sin).unwrap();
        let close = |found: f64, expected: f64, bound: f64| {
            let miss = (found - expected).abs();
            assert!(
                miss <= bound * expected.abs(),
                "{found} {expected} at {angle}"
            );
        };
        close(factor, angle / sin, 1e-15);
        if angle > 0.3 {
            close(slope, (cos * angle / sin - 1.0) / (sin * sin), 4e-14);
        }
        let (c, s) = (cos as f32, -(sin * sin) as f32);
        let root = f64::from(-s).sqrt();
        let (single, single_slope) = c.log_factor_slope(s).unwrap();
        close(single.into(), root.atan2(c.into()) / root, 5e-7);
        close(single_slope.into(), slope, 2e-6 / (1.0 + cos));
        let (cosh, sinh) = (angle.cosh(), angle.sinh());
        let boost = cosh.log_factor(sinh * sinh).unwrap();
        close(boost, angle / sinh, 1e-15);
    }
}

/// Bit for bit, for one function on lanes and alone.
fn assert_lanes<L: Lanes<Float: Real>>(
    values: &[L::Float],
    packed: impl Fn(&[L::Float]) -> L,
    lanes: fn(L) -> L,
    alone: fn(L::Float) -> L::Float,
    count: usize,
) {
    for chunk in values.chunks_exact(count) {
        let found = lanes(packed(chunk));
        let expected = packed(&chunk.iter().map(|&x| alone(x)).collect::<Vec<_>>());
        let same = found.zip(expected, |found, expected| {
            let is_nan = |x: L::Float| !x.is_at_most(x);
            let same = found == expected || is_nan(found) && is_nan(expected);
            L::Float::rounded(if same { 0.0 } else { 1.0 })
        });
        assert!(L::all(same.is_at_most(L::ZERO)), "{found:?} {expected:?}");
    }
}

#[cfg(feature = "wide")]
#[test]
fn lanes_are_like_numbers_alone() {
    use wide::{f32x4, f32x8, f32x16, f64x2, f64x4, f64x8};

    // Neighbours of every kind.
    let mut values = samples();
    let mut random = rand::rngs::StdRng::seed_from_u64(5);
    for i in 0..values.len() {
        let other = random.random_range(0..values.len());
        values.swap(i, other);
    }
    let singles: Vec<f32> = values.iter().map(|&x| x as f32).collect();
    macro_rules! check {
        ($($lanes:ident $float:ident $count:literal $values:ident;)*) => {$(
            let packed = |values: &[$float]| {
                let mut lanes = [0.0; $count];
                lanes.copy_from_slice(values);
                $lanes::new(lanes)
            };
            let functions: [(fn($lanes) -> $lanes, fn($float) -> $float); 10] = [
                (Real::exp, Real::exp),
                (Real::ln, Real::ln),
                (Real::sqrt, Real::sqrt),
                (Real::abs, Real::abs),
                (|x| Real::sin_cos(x).0, |x| Real::sin_cos(x).0),
                (|x| Real::sin_cos(x).1, |x| Real::sin_cos(x).1),
                (|x| x.cosh_sinhc().0, |x| x.cosh_sinhc().0),
                (|x| x.cosh_sinhc().1, |x| x.cosh_sinhc().1),
                (|x| x.cosh_sinhc_slope().2, |x| x.cosh_sinhc_slope().2),
                (|x| Real::atan2(x, x * x - $lanes::ONE), |x| Real::atan2(x, x * x - 1.0)),
            ];
            for (lanes, alone) in functions {
                assert_lanes::<$lanes>(&$values, packed, lanes, alone, $count);
            }
        )*};
    }
    check! {
        f32x4 f32 4 singles;
        f32x8 f32 8 singles;
        f32x16 f32 16 singles;
        f64x2 f64 2 values;
        f64x4 f64 4 values;
        f64x8 f64 8 values;
    }
}
