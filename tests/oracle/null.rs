//! Types declared null in an oblique metric: with a fixed coefficient on a null vector, whose
//! images are squares of spinors, and without.

use ga::core::{Metric, Narrowing, Rational};

use crate::conversions::{check_conversions, check_masks};
use crate::divisions::check_divisions;
use crate::operators::{check_operators, check_references, check_sums};
use crate::presets::check_everything;
use crate::products::check_products;
use crate::unary::{check_duals, check_unary};
use crate::versors::check_versors;

ga::define_algebra! {
    /// Two oblique vectors, and two null ones.
    pub mod cone: R3_1 {
        basis { n, x, m, y }
        metric { x^2 = 2, x.y = 1, y^2 = 3, n.m = -3/2 }
        types {
            Vector { x, y, m, n }
            #[null] Point { m, n = 2, y, x }
            #[null] Ray { n, m, x, y }
            Bivector = grade 2;
            #[unit] Motor { 1, x^y, x^m, y^m }
            Turn { 1, y^x }
        }
    }
}

fn metric() -> Metric {
    let gram = [[0, 0, -3, 0], [0, 4, 0, 2], [-3, 0, 0, 0], [0, 2, 0, 6]];
    let gram = gram.map(|row| row.map(|x| Rational::new(x, 2)).to_vec());
    Metric::new(["n", "x", "m", "y"], gram.to_vec()).expect("symmetric")
}

check_everything! { oblique_cone, cone, metric(), ["Motor"],
[Vector Point Ray Bivector Motor Turn Scalar Even Odd Multivector], check_duals }

/// Narrowing refuses what does not square to 0, up to its tolerance.
#[test]
fn narrowing() {
    use cone::{Point, Ray, Vector};
    // 2 x² + 2 x y + 3 y² = 6 m
    let null = Vector::new(1.0, 2.0, 3.0, 2.0);
    assert_eq!(Point::try_from(null), Ok(Point::new(3.0, 2.0, 1.0)));
    assert_eq!(Ray::try_from(null * 2.0), Ok(Ray::new(4.0, 6.0, 2.0, 4.0)));
    let refused = Err(Narrowing {
        blade: ga::core::Blade::new(0),
        square: true,
    });
    let off = Vector { m: 3.0001, ..null };
    assert_eq!(Point::try_from(off), refused);
    assert_eq!(off.narrow(1e-3), Ok(Point::new(3.0001, 2.0, 1.0)));
    let unknown = Vector {
        m: f64::NAN,
        ..null
    };
    assert!(Point::try_from(unknown).is_err());
    assert!(
        Ray::try_from(Vector {
            n: f64::INFINITY,
            ..null
        })
        .is_err()
    );
    // Exact numbers tolerate nothing.
    let exact = |m: Rational| {
        let number = Rational::from_integer;
        Point::try_from(Vector::new(number(1), number(2), m, number(2))).is_ok()
    };
    assert!(exact(Rational::from_integer(3)));
    assert!(!exact(Rational::new(3_000_000_001, 1_000_000_000)));
    assert_eq!(
        Ray::try_from(Vector::new(0.0, 0.0, 0.0, 0.0)),
        Ok(Ray::default())
    );
}
