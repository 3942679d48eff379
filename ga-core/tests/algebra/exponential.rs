//! The dense exponential against closed forms and its own laws.

use ga_core::dense::{Algebra, Dense, DenseError};
use ga_core::{Blade, Real};

use crate::catalogue;

fn assert_close(a: &Dense<f64>, b: &Dense<f64>, tolerance: f64) {
    for (a, b) in a.coefficients().iter().zip(b.coefficients()) {
        assert!((a - b).abs() <= tolerance, "{a} against {b}");
    }
}

#[test]
fn simple_bivectors_follow_the_closed_form() {
    for (p, q, r) in [(2, 0, 0), (1, 1, 0), (1, 0, 1)] {
        let algebra = Algebra::<f64>::new(&catalogue::orthonormal(p, q, r)).unwrap();
        let e12 = Blade::new(0b11);
        for angle in [0.0, 1e-9, 0.3, -2.0, 3.2, 17.0] {
            let bivector = algebra.blade(e12, angle).unwrap();
            let square = bivector
                .geometric(&bivector)
                .unwrap()
                .coefficient(Blade::SCALAR);
            let (c, s) = square.cosh_sinhc();
            let expected = algebra
                .from_terms([(Blade::SCALAR, c), (e12, s * angle)])
                .unwrap();
            assert_close(
                &bivector.exp().unwrap(),
                &expected,
                2e-14 * c.abs().max(1.0),
            );
        }
    }
}

#[test]
fn exponentials_of_opposites_are_inverse_in_every_metric() {
    for (name, metric) in catalogue::all() {
        let algebra = Algebra::<f64>::new(&metric).unwrap();
        let size = 1 << metric.dimension();
        let coefficients = (0..size).map(|k: i32| f64::from(k * 29 % 17 - 8) / 20.0);
        let element = algebra.from_coefficients(coefficients.collect()).unwrap();
        let bivector = element.grade(2);
        let there = bivector.exp().unwrap();
        let back = bivector.scale(-1.0).exp().unwrap();
        let product = there.geometric(&back).unwrap();
        let miss = product.sub(&algebra.scalar(1.0)).unwrap();
        let worst = miss
            .coefficients()
            .iter()
            .fold(0.0_f64, |worst, miss| worst.max(miss.abs()));
        assert!(worst < 1e-8, "{worst} in {name}");
    }
}

#[test]
fn what_is_too_large_is_reported() {
    let algebra = Algebra::<f64>::new(&catalogue::orthonormal(1, 1, 0)).unwrap();
    for scale in [1e4, 1e308, f64::INFINITY, f64::NAN] {
        let boost = algebra.blade(Blade::new(0b11), scale).unwrap();
        assert_eq!(boost.exp(), Err(DenseError::NotFinite), "{scale}");
    }
}
