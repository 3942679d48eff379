//! The numbers: accuracy, edges of domains, derivatives.

use ga_core::{Dual, Field, Real, Scalar};
use num_rational::Ratio;

fn assert_relative<T: Real + PartialOrd>(found: T, expected: f64, tolerance: f64) {
    let expected = T::from_f64(expected);
    let miss = (found - expected).abs();
    assert!(
        miss.all_le(expected.abs() * T::from_f64(tolerance)),
        "{found:?} instead of {expected:?}"
    );
}

/// (a, cosh √a, sinh √a / √a), by mpmath 1.3.0 with 40 digits.
const COSH_SINHC: [(f64, f64, f64); 10] = [
    (-10000.0, 0.8623188722876839, -0.005063656411097588),
    (-30.0, 0.6924191115937478, -0.13172645569509123),
    (-2.5, -0.010342318905209131, 0.6324217062813904),
    (-1.0, 0.5403023058681398, 0.8414709848078965),
    (-0.001, 0.9995000416652778, 0.9998333416664683),
    (1e-20, 1.0, 1.0),
    (0.5, 1.2605918365213562, 1.085441641272607),
    (1.5, 1.8485651746467933, 1.2694337858318119),
    (40.0, 279.05568512996325, 44.12229464889411),
    (100000.0, 1.0837866822865718e+137, 3.427234413782831e+134),
];

/// (c, s, log factor) with c² − s = 1 to rounding, by mpmath 1.3.0 with 40 digits from the
/// rounded c and s as atan2(√−s, c)/√−s or asinh(√s)/√s.
const LOG_FACTOR: [(f64, f64, f64); 15] = [
    (1.0, -1e-18, 1.0),
    (0.999999995, -9.999999966666668e-09, 1.0000000016666666),
    (0.955336489125606, -0.08733219254516084, 1.0151590085472368),
    (0.0707372016677029, -0.9949962483002227, 1.5037669563700873),
    (
        -0.029199522301288815,
        -0.9991473878973764,
        1.600682526160671,
    ),
    (-0.9899924966004454, -0.01991485667481699, 21.25850218721156),
    (
        -0.9999999957076562,
        -8.584687676974508e-09,
        33905.8638905559,
    ),
    (-1.0, -1.0000000123379942e-16, 314159262.42093176),
    (1.0, 1e-18, 1.0),
    (1.000000005, 1.0000000033333334e-08, 0.9999999983333333),
    (1.020066755619076, 0.04053618591922742, 0.9933643137629034),
    (1.255169005630943, 0.5754492326965701, 0.922772264026408),
    (10.067661995777765, 100.35781806122796, 0.2994647090064682),
    (
        5343237290762.231,
        2.855018474539211e+25,
        5.614573781304104e-12,
    ),
    (
        9.712131976206279e+129,
        9.432550752324849e+259,
        3.0889201334472084e-128,
    ),
];

#[test]
fn cosh_and_sinhc_are_accurate() {
    for (a, c, s) in COSH_SINHC {
        // The rounding of √a is magnified by √a.
        let root = a.abs().sqrt();
        let units = |epsilon: f64| 2.0 * epsilon * (1.0 + root);
        let (cosh, sinhc) = a.cosh_sinhc();
        let (single_cosh, single_sinhc) = (a as f32).cosh_sinhc();
        for (found, expected, scale) in [(cosh, c, 1.0), (sinhc, s, 1.0 / (1.0 + root))] {
            let bound = expected.abs().max(scale) * units(f64::EPSILON);
            assert!((found - expected).abs() <= bound, "{found} at {a}");
        }
        for (found, expected) in [(single_cosh, c), (single_sinhc, s)] {
            let bound = expected.abs().max(1.0) * units(f32::EPSILON.into());
            let overflown = expected > f32::MAX.into() && found == f32::INFINITY;
            assert!(
                (f64::from(found) - expected).abs() <= bound || overflown,
                "{found} at {a}"
            );
        }
    }
    assert_eq!(0.0.cosh_sinhc(), (1.0, 1.0));
    assert_eq!(f64::MAX.cosh_sinhc(), (f64::INFINITY, f64::INFINITY));
    assert_eq!(f64::INFINITY.cosh_sinhc(), (f64::INFINITY, f64::INFINITY));
}

#[test]
fn log_factors_are_accurate() {
    for (c, s, factor) in LOG_FACTOR {
        assert_relative(c.log_factor(s).unwrap(), factor, 4e-16);
    }
    assert_eq!(1.0.log_factor(0.0), Some(1.0));
    assert_eq!(1.0.log_factor(-0.0), Some(1.0));
}

#[test]
fn logarithms_that_do_not_exist() {
    let none: [(f64, f64); 11] = [
        (0.5, -1e300),
        (1e10, -1.0),
        (-1.0, 0.0),
        (-1.0, -0.0),
        (-2.0, 3.0),
        (0.0, 0.0),
        (-0.0, 1.0),
        (f64::NAN, -1.0),
        (0.5, f64::NAN),
        (f64::INFINITY, f64::INFINITY),
        (1e-310, 0.0),
    ];
    for (c, s) in none {
        assert_eq!(c.log_factor(s), None, "{c} {s}");
        assert_eq!(Dual::variable(c).log_factor(Dual::constant(s)), None);
    }
    assert_eq!((-1.0_f32).log_factor(0.0), None);
}

#[test]
fn reciprocals() {
    for (value, invertible) in [
        (2.0, true),
        (0.0, false),
        (1e-310, false),
        (f64::NAN, false),
    ] {
        assert_eq!(value.is_invertible(), invertible);
        assert_eq!(Dual::variable(value).is_invertible(), invertible);
    }
    assert!(!f64::INFINITY.is_invertible());
    assert!(!Ratio::<i64>::ZERO.is_invertible());
    assert!(!Ratio::new(i64::MIN, 1).is_invertible());
    assert!(Ratio::new(-3_i128, 7).is_invertible());
    assert_eq!(<Ratio<i64> as Field>::from_ratio(6, -4), Ratio::new(-3, 2));
    assert_eq!(f32::from_ratio(1, 4), 0.25);
    assert_eq!(<i64 as Scalar>::from_integer(-7), -7);
}

/// Every function of one variable with its dual evaluation, its value by central differences
/// of fourth order as the judge.
#[test]
fn derivatives_are_right() {
    type Function = fn(Dual<f64>) -> Dual<f64>;
    let functions: [(&str, Function, &[f64]); 9] = [
        ("sqrt", Real::sqrt, &[0.5, 4.0]),
        ("exp", Real::exp, &[-1.0, 0.0, 2.0]),
        ("ln", Real::ln, &[0.5, 3.0]),
        ("abs", Real::abs, &[-2.0, 3.0]),
        ("sin", |x| x.sin_cos().0, &[0.0, 1.0, -2.0]),
        ("cos", |x| x.sin_cos().1, &[0.0, 1.0, -2.0]),
        (
            "cosh",
            |x| x.cosh_sinhc().0,
            &[-9.0, -1.1, -0.2, 0.0, 0.2, 1.1, 9.0],
        ),
        (
            "sinhc",
            |x| x.cosh_sinhc().1,
            &[-9.0, -1.1, -0.2, 0.0, 0.2, 1.1, 9.0],
        ),
        (
            "atan2",
            |x| x.atan2(Dual::ONE - x * x),
            &[-2.0, 0.0, 0.5, 3.0],
        ),
    ];
    for (name, function, points) in functions {
        for &point in points {
            let value = |x: f64| function(Dual::constant(x)).re;
            let h = 1e-3;
            let near = (value(point + h) - value(point - h)) * 8.0;
            let far = value(point + 2.0 * h) - value(point - 2.0 * h);
            let slope = (near - far) / (12.0 * h);
            let found = function(Dual::variable(point)).eps;
            let miss = (found - slope).abs();
            assert!(
                miss < 1e-9 * slope.abs().max(1.0),
                "{name} at {point}: {found} {slope}"
            );
        }
    }
}

/// Along c = cos θ, s = −sin² θ the factor is θ/sin θ; along c = cosh φ, s = sinh² φ it is
/// φ/sinh φ. Both with first and second derivative, by nested dual numbers.
#[test]
fn derivatives_of_the_logarithm() {
    for angle in [1e-5, 0.1, 0.24, 0.26, 1.0, 2.0, 3.0] {
        let theta = Dual::new(Dual::variable(angle), Dual::ONE);
        let (sin, cos) = theta.sin_cos();
        let found = cos.log_factor(-(sin * sin)).unwrap();
        let expected = theta / sin;
        assert_relative(found.re.re, expected.re.re, 1e-14);
        if angle > 0.01 {
            assert_relative(found.eps.re, expected.eps.re, 1e-11);
            assert_relative(found.eps.eps, expected.eps.eps, 1e-9);
        } else {
            // θ/sin θ = 1 + θ²/6 + …
            assert_relative(found.eps.re, angle / 3.0, 1e-9);
            assert_relative(found.eps.eps, 1.0 / 3.0, 1e-9);
        }
    }
    for rapidity in [0.1, 0.24, 0.26, 1.0, 5.0, 20.0] {
        let phi = Dual::variable(rapidity);
        let (cosh, sinhc) = (phi * phi).cosh_sinhc();
        let sinh = phi * sinhc;
        let found = cosh.log_factor(sinh * sinh).unwrap();
        let expected = phi / sinh;
        assert_relative(found.re, expected.re, 1e-14);
        assert_relative(found.eps, expected.eps, 1e-11);
    }
    // At the identity: f = 1 − s/6 + … along c = √(1 + s).
    let s = Dual::variable(0.0);
    let c = (Dual::ONE + s).sqrt();
    let factor = c.log_factor(s).unwrap();
    assert_relative(factor.re, 1.0, 1e-15);
    assert_relative(factor.eps, -1.0 / 6.0, 1e-15);
}

#[test]
fn edges_of_dual_numbers() {
    assert_eq!(Dual::constant(0.0).sqrt(), Dual::constant(0.0));
    assert_eq!(Dual::variable(0.0).sqrt(), Dual::new(0.0, f64::INFINITY));
    assert_eq!(Dual::constant(0.0).ln(), Dual::constant(f64::NEG_INFINITY));
    assert_eq!(
        Dual::constant(0.0).atan2(Dual::constant(0.0)),
        Dual::constant(0.0)
    );
    assert_eq!(Dual::constant(1e4).exp(), Dual::constant(f64::INFINITY));
    assert_eq!(
        Dual::variable(0.0).cosh_sinhc(),
        (Dual::new(1.0, 0.5), Dual::new(1.0, 1.0 / 6.0))
    );
    assert!(!Dual::new(1.0, f64::NAN).is_finite());
    assert!(Dual::new(1.0, 9.0).all_le(Dual::new(1.0, 0.0)));
    let (a, b) = (Dual::new(1, 2), Dual::from(3_i64));
    assert_eq!(a * b + a - b, Dual::new(1, 8));
    assert_eq!(
        Dual::variable(6.0) / Dual::constant(3.0),
        Dual::new(2.0, 1.0 / 3.0)
    );
}

#[cfg(feature = "wide")]
mod lanes {
    //! A lane is computed as a number alone would be, whatever the other lanes hold.

    use ga_core::{Dual, Field, Real, Scalar};
    use wide::{f32x4, f32x8, f64x2, f64x4};

    const VALUES: [f64; 4] = [0.0, -3.0, 0.25, 1e300];

    fn assert_same(found: f64, expected: f64) {
        assert!(
            found == expected || found.is_nan() && expected.is_nan(),
            "{found} {expected}"
        );
    }

    #[test]
    fn functions_run_lane_by_lane() {
        type Pair = (fn(f64x4) -> f64x4, fn(f64) -> f64);
        let functions: [Pair; 9] = [
            (Real::abs, Real::abs),
            (Real::sqrt, Real::sqrt),
            (Real::exp, Real::exp),
            (Real::ln, Real::ln),
            (|x| Real::sin_cos(x).0, |x| Real::sin_cos(x).0),
            (|x| Real::sin_cos(x).1, |x| Real::sin_cos(x).1),
            (|x| x.cosh_sinhc().0, |x| x.cosh_sinhc().0),
            (|x| x.cosh_sinhc().1, |x| x.cosh_sinhc().1),
            (|x| Real::atan2(x, f64x4::ONE), |x| Real::atan2(x, 1.0)),
        ];
        for (lanes, single) in functions {
            for (found, value) in lanes(f64x4::new(VALUES)).to_array().into_iter().zip(VALUES) {
                assert_same(found, single(value));
            }
        }
    }

    /// The discarded branch of a dual number divides by zero in the first lane.
    #[test]
    fn derivatives_run_lane_by_lane() {
        let value = f64x4::new([0.0, -3.0, 0.25, 40.0]);
        let (cosh, sinhc) = Dual::variable(value).cosh_sinhc();
        for (lane, value) in value.to_array().into_iter().enumerate() {
            let expected = Dual::variable(value).cosh_sinhc();
            assert_same(cosh.eps.to_array()[lane], expected.0.eps);
            let miss = sinhc.eps.to_array()[lane] - expected.1.eps;
            assert!(miss.abs() <= 1e-15 * expected.1.eps.abs());
        }
    }

    #[test]
    fn predicates_hold_in_every_lane() {
        assert!(!f64x2::new([1.0, 0.0]).is_invertible());
        assert!(f64x2::new([1.0, -2.0]).is_invertible());
        assert!(!f32x8::from_integer(3).all_le(f32x8::from_f64(2.0)));
        assert!(f32x4::from_integer(3).all_le(f32x4::from_ratio(7, 2)));
        assert!(!Real::is_finite(f64x2::new([1.0, f64::NAN])));
        let (c, s) = (f64x2::new([1.0, 0.6]), f64x2::new([0.0, -0.64]));
        let factor = c.log_factor(s).unwrap().to_array();
        assert_eq!(Some(factor[1]), 0.6_f64.log_factor(-0.64));
        assert_eq!(f64x2::new([1.0, -1.0]).log_factor(f64x2::ZERO), None);
        let chosen = f64x2::new([1.0, 3.0]).select_le(f64x2::splat(2.0), f64x2::ZERO, f64x2::ONE);
        assert_eq!(chosen.to_array(), [0.0, 1.0]);
    }
}
