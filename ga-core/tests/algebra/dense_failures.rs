//! What the run-time algebra refuses, and how it says so.

use ga_core::dense::{Algebra, DenseError};
use ga_core::{Blade, Metric, Rational};

use crate::catalogue;

#[test]
fn algebras() {
    let thirteen = catalogue::orthonormal(13, 0, 0);
    let error = Algebra::<f64>::new(&thirteen).unwrap_err();
    assert_eq!(error, DenseError::TooManyDimensions { dimension: 13 });
    assert!(
        error
            .to_string()
            .starts_with("13 dimensions are more than the 12")
    );

    let error = Algebra::<i64>::integral(&catalogue::oblique()).unwrap_err();
    assert_eq!(error, DenseError::InnerProduct { row: 1, column: 2 });

    let large = vec![vec![Rational::from_integer(1 << 80)]];
    let error = Algebra::<f64>::new(&Metric::new(["a"], large).unwrap()).unwrap_err();
    assert_eq!(error, DenseError::InnerProduct { row: 0, column: 0 });
}

#[test]
fn operands() {
    let space = Algebra::<f64>::new(&catalogue::orthonormal(3, 0, 0)).unwrap();
    let plane = Algebra::<f64>::new(&catalogue::orthonormal(2, 0, 0)).unwrap();
    let (a, b) = (space.scalar(2.0), plane.scalar(2.0));
    let different = Err(DenseError::DifferentAlgebras);
    assert_eq!(a.add(&b), different);
    assert_eq!(a.sub(&b), different);
    assert_eq!(a.apply(&b), different);
    assert_eq!(a.meet(&b), different);
    for which in ga_core::Product::ALL {
        assert_eq!(a.product(which, &b), different, "{which:?}");
    }
    // The same inner products make the same algebra.
    let again = Algebra::<f64>::new(&catalogue::orthonormal(3, 0, 0)).unwrap();
    assert!(a.geometric(&again.scalar(1.0)).is_ok());

    let beyond = Blade::new(0b1000);
    assert_eq!(
        space.blade(beyond, 1.0),
        Err(DenseError::NoSuchBlade(beyond))
    );
    assert_eq!(a.coefficient(beyond), 0.0);
    let count = |given, needed| Err(DenseError::CoefficientCount { given, needed });
    assert_eq!(space.vector(&[1.0]), count(1, 3));
    assert_eq!(space.from_coefficients(vec![0.0; 9]), count(9, 8));
    assert!(a.grade(7).is_zero());
}

#[test]
fn inverses() {
    let plane = Algebra::<f64>::new(&catalogue::orthonormal(2, 0, 1)).unwrap();
    let null = plane.vector(&[0.0, 0.0, 1.0]).unwrap();
    assert_eq!(null.inverse(), Err(DenseError::NotInvertible));
    assert_eq!(null.apply(&null), Err(DenseError::NotInvertible));
    assert_eq!(plane.zero().inverse(), Err(DenseError::NotInvertible));
    assert_eq!(null.dual(), Err(DenseError::Degenerate));
    let mixed = plane.scalar(1.0).add(&null).unwrap();
    assert_eq!(mixed.apply(&null), Err(DenseError::MixedParity));
    let huge = plane.scalar(1e300);
    assert_eq!(huge.inverse(), Err(DenseError::NotInvertible));
    assert!(plane.scalar(f64::NAN).inverse().is_err());
}

/// In six dimensions the inverse is polished: generic elements return to 1.
#[test]
fn inverse_in_six_dimensions() {
    for (p, q) in [(6, 0), (3, 3), (4, 2), (2, 4)] {
        let algebra = Algebra::<f64>::new(&catalogue::orthonormal(p, q, 0)).unwrap();
        let coefficients = (0..64).map(|k: i32| f64::from(k * k * 37 % 101) / 101.0 - 0.5);
        let element = algebra.from_coefficients(coefficients.collect()).unwrap();
        let product = element.geometric(&element.inverse().unwrap()).unwrap();
        let miss = product.sub(&algebra.scalar(1.0)).unwrap();
        assert!(miss.coefficients().iter().all(|value| value.abs() < 1e-11));
    }
}
