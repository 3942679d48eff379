//! Exponentials against the dense algebra; logarithms and roots as their inverses, and where
//! there are none.

use std::f64::consts::PI;

use ga::cga::cga3;
use ga::core::dense::Algebra;
use ga::core::ops::*;
use ga::core::{Blade, Metric};

use crate::metrics::null_basis;
use crate::presets::{r0_2, r1_3, r2, r3, r3_0_1, r4_1};
use crate::samples::Samples;
use crate::six_dimensions::{r3_3, r6};

/// All coefficients by bitmask.
fn coefficients<X: Element<Number = f64>>(algebra: &Algebra<f64>, x: &X) -> Vec<f64> {
    let mut value = algebra.zero().coefficients().to_vec();
    for (i, (blade, sign)) in X::BLADES.iter().enumerate() {
        value[blade.mask() as usize] = x.at(i) * f64::from(*sign);
    }
    for (blade, sign, numerator, denominator) in X::FIXED {
        value[blade.mask() as usize] = f64::from(*sign) * *numerator as f64 / *denominator as f64;
    }
    value
}

/// Compares exponentials of random elements and of single blades.
fn exponential<X>(metric: &Metric)
where
    X: Element<Number = f64> + Exponential<Output: Element<Number = f64>>,
{
    let algebra: Algebra<f64> = Algebra::new(metric).expect("few dimensions");
    let mut samples = Samples::new(71);
    for size in [0.0, 1e-200, 1e-9, 1e-3, 0.3, 1.0, 2.5] {
        let x = X::from_fn(|_| size * samples.float());
        let blade = X::from_fn(|i| if i == 0 { size } else { 0.0 });
        for x in [x, blade] {
            let dense = algebra
                .from_coefficients(coefficients(&algebra, &x))
                .expect("all");
            let expected = dense.exp().expect("finite");
            let generated = coefficients(&algebra, &x.exp());
            let largest = expected
                .coefficients()
                .iter()
                .fold(1.0_f64, |m, v| m.max(v.abs()));
            for (generated, expected) in generated.iter().zip(expected.coefficients()) {
                let error = (generated - expected).abs() / largest;
                assert!(error <= 1e-14, "{error:e} {}", std::any::type_name::<X>());
            }
        }
    }
}

#[test]
fn exponentials_are_those_of_the_dense_algebra() {
    let metric = |p, q, r| Metric::from_signature(p, q, r).expect("few dimensions");
    exponential::<r2::Bivector>(&metric(2, 0, 0));
    exponential::<r0_2::Bivector>(&metric(0, 2, 0));
    exponential::<r0_2::Vector>(&metric(0, 2, 0));
    exponential::<r3::Bivector>(&metric(3, 0, 0));
    exponential::<r3::Vector>(&metric(3, 0, 0));
    exponential::<r3::Multivector>(&metric(3, 0, 0));
    exponential::<r3_0_1::Bivector>(&metric(3, 0, 1));
    exponential::<r1_3::Bivector>(&metric(1, 3, 0));
    exponential::<r1_3::Even>(&metric(1, 3, 0));
    exponential::<r4_1::Bivector>(&metric(4, 1, 0));
    exponential::<r6::Bivector>(&metric(6, 0, 0));
    exponential::<r3_3::Bivector>(&metric(3, 3, 0));
}

#[test]
fn exponentials_in_the_null_basis() {
    let metric = null_basis();
    exponential::<cga3::Bivector3>(&metric);
    exponential::<cga3::DirectionVector>(&metric);
    exponential::<cga3::TangentVector>(&metric);
    exponential::<cga3::MinkowskiPlane>(&metric);
    exponential::<cga3::DualLine>(&metric);
    exponential::<cga3::PointPair>(&metric);
    // With fixed coefficients.
    exponential::<cga3::Point>(&metric);
    exponential::<cga3::Translator>(&metric);
}

/// A unit bivector of the space.
fn plane() -> r3::Bivector {
    r3::Bivector::new(2.0 / 3.0, -1.0 / 3.0, 2.0 / 3.0)
}

fn distance<X: Element<Number = f64>>(a: X, b: X) -> f64 {
    (0..X::BLADES.len()).fold(0.0, |sum, i| sum + (a.at(i) - b.at(i)).abs())
}

#[test]
fn the_logarithm_undoes_the_exponential() {
    let near = [PI - 1e-3, PI - 1e-8, PI - 1e-14];
    for angle in [
        0.0_f64,
        1e-300,
        1e-160,
        1e-17,
        1e-9,
        0.5,
        PI / 2.0,
        2.0,
        3.0,
    ]
    .into_iter()
    .chain(near)
    {
        let b = angle * plane();
        let rotor = b.exp();
        let log = rotor.log().expect("below π");
        let tolerance = 4e-15 * angle.max(f64::MIN_POSITIVE);
        assert!(distance(log, b) <= tolerance, "{angle}: {log} for {b}");
        assert!(distance(log.exp(), rotor) <= 1e-15 * 4.0);
        // The logarithm is that of the versor over its norm.
        let longer = (rotor * 3.0).log().expect("below π");
        assert!(distance(longer, b) <= 2.0 * tolerance + 1e-300);
    }
    for rapidity in [0.0_f64, 1e-200, 1e-8, 0.4, 3.0, 15.0] {
        let boost = cga3::MinkowskiPlane::new(rapidity).exp();
        let log = boost.log().expect("a boost");
        assert!(
            (log.noni - rapidity).abs() <= 1e-14 * rapidity.max(1e-300),
            "{rapidity} {log}"
        );
    }
    let complex = r2::Bivector::new(-1.25_f64).exp();
    assert!((complex.log().expect("below π").e12 + 1.25).abs() < 1e-15);
}

#[test]
fn the_square_of_the_root_is_the_versor() {
    for angle in [0.0, 1e-200, 1e-9, 0.5, 2.0, 3.0, PI - 1e-6, PI - 1e-13] {
        for length in [1e-3, 1.0, 250.0] {
            let rotor = (angle * plane()).exp() * length;
            let root = rotor.sqrt().expect("below π");
            assert!(root.s >= 0.0);
            assert!(
                distance(root * root, rotor) <= 1e-14 * length,
                "{angle} {length}"
            );
        }
    }
    for rapidity in [0.0_f64, 1e-9, 2.0] {
        let boost = cga3::MinkowskiPlane::new(rapidity).exp();
        let root = boost.sqrt().expect("a boost");
        let expected = cga3::MinkowskiPlane::new(rapidity / 2.0).exp();
        assert!(distance(root, expected) < 1e-14);
    }
}

#[test]
fn what_has_no_logarithm_says_so() {
    let none = [
        r3::Even::new(-1.0, 0.0, 0.0, 0.0),
        r3::Even::new(0.0, 0.0, 0.0, 0.0),
        r3::Even::new(f64::NAN, 0.0, 0.0, 0.0),
        r3::Even::new(f64::INFINITY, 0.0, 0.0, 0.0),
        r3::Even::new(1.0, f64::NAN, 0.0, 0.0),
        r3::Even::new(0.0, f64::INFINITY, 0.0, 0.0),
    ];
    for rotor in none {
        assert_eq!(rotor.log(), None, "{rotor}");
        assert_eq!(rotor.sqrt(), None, "{rotor}");
    }
    let boost = cga3::MinkowskiPlane::new(1.5).exp();
    let none = [
        cga3::Dilator::new(-boost.s, boost.noni),
        cga3::Dilator::new(1.0, 2.0),
        cga3::Dilator::new(1.0, 1.0),
        cga3::Dilator::new(-1.0, 0.0),
    ];
    for dilator in none {
        assert_eq!(dilator.log(), None, "{dilator}");
        assert_eq!(dilator.sqrt(), None, "{dilator}");
    }
}

/// Values of every size give finite results or none.
#[test]
fn results_are_finite() {
    let sizes = [0.0, 1e-320, 1e-300, 1e-155, 1e-20, 1.0, 1e20, 1e150];
    for s in sizes {
        for e in sizes {
            for sign in [1.0, -1.0] {
                let rotor = r3::Even::new(sign * s, e, 0.0, -e);
                let finite = |x: f64| x.is_finite();
                if let Some(log) = rotor.log() {
                    assert!(log.to_array().into_iter().all(finite), "{rotor}: {log}");
                }
                if let Some(root) = rotor.sqrt() {
                    assert!(root.to_array().into_iter().all(finite), "{rotor}: {root}");
                }
                let boost = cga3::Dilator::new(sign * s, e);
                assert!(
                    boost.log().is_none_or(|log| log.noni.is_finite()),
                    "{boost}"
                );
                assert!(
                    boost.sqrt().is_none_or(|root| root.s.is_finite()),
                    "{boost}"
                );
            }
        }
    }
    assert_eq!(r3::Even::<f64>::BLADES[0].0, Blade::SCALAR);
}
