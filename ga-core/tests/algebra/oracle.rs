//! Products, involutions and duals of basis blades against the dense reference, for every pair
//! of blades in every metric of the catalogue.

use ga_core::dense::{Algebra, Dense, DenseError};
use ga_core::dual::{dual, left_complement, right_complement, undual};
use ga_core::product::product;
use ga_core::{Blade, Field, Involution, Metric, Product, Rational};

use crate::catalogue;

fn algebra(metric: &Metric) -> Algebra<Rational> {
    Algebra::new(metric).unwrap()
}

fn unit(algebra: &Algebra<Rational>, blade: Blade) -> Dense<Rational> {
    algebra.blade(blade, Rational::ONE).unwrap()
}

/// Compares products of all pairs of blades, in coefficients that hold the results exactly.
fn compare_products<T: Field>(
    name: &str,
    metric: &Metric,
    products: &[Product],
    exact: impl Fn(Rational) -> T,
) {
    let algebra = Algebra::new(metric).unwrap();
    let unit = |blade| algebra.blade(blade, T::ONE).unwrap();
    for a in metric.blades() {
        for b in metric.blades() {
            for &which in products {
                let slow = unit(a).product(which, &unit(b)).unwrap().terms();
                let fast = product(metric, which, a, b).unwrap().into_iter();
                let fast: Vec<_> = fast.map(|(blade, value)| (blade, exact(value))).collect();
                assert_eq!(fast, slow, "{which:?} of {a:?} and {b:?} in {name}");
            }
        }
    }
}

#[test]
fn every_product_of_every_pair_of_blades() {
    for (name, metric) in catalogue::all() {
        if metric.dimension() < 6 {
            compare_products(name, &metric, &Product::ALL, |value| value);
        } else {
            // Small numbers, exact in floating point and faster. The other products are parts
            // of the geometric one; that they are the right parts one such metric shows.
            let all = if name == "R3_3" {
                Product::ALL.len()
            } else {
                1
            };
            let exact = |value: Rational| *value.numer() as f64 / *value.denom() as f64;
            compare_products(name, &metric, &Product::ALL[..all], exact);
        }
    }
}

#[test]
fn duals_and_complements() {
    for (name, metric) in catalogue::all() {
        let algebra = algebra(&metric);
        let signed = |(blade, sign): (Blade, i32)| vec![(blade, Rational::from(i128::from(sign)))];
        for blade in metric.blades() {
            let dense = unit(&algebra, blade);
            let n = metric.dimension();
            assert_eq!(
                signed(right_complement(n, blade)),
                dense.right_complement().terms()
            );
            assert_eq!(
                signed(left_complement(n, blade)),
                dense.left_complement().terms()
            );
            assert_eq!(
                undual(&metric, blade),
                Some(dense.undual().terms()),
                "in {name}"
            );
            match dense.dual() {
                Ok(expected) => assert_eq!(dual(&metric, blade), Some(expected.terms())),
                Err(error) => {
                    assert_eq!(error, DenseError::Degenerate);
                    assert_eq!(dual(&metric, blade), None);
                    assert!(metric.is_degenerate());
                }
            }
        }
    }
}

#[test]
fn involutions() {
    let metric = catalogue::orthonormal(6, 0, 0);
    let algebra = algebra(&metric);
    for blade in metric.blades() {
        let dense = unit(&algebra, blade);
        for involution in Involution::ALL {
            let slow = match involution {
                Involution::Reverse => dense.reverse(),
                Involution::Involute => dense.involute(),
                Involution::Conjugate => dense.conjugate(),
            };
            let sign = Rational::from(i128::from(involution.sign(blade.grade())));
            assert_eq!(slow, dense.scale(sign), "{involution:?} of {blade:?}");
        }
    }
}

/// I Ĩ is the determinant of the Gram matrix.
#[test]
fn determinant_is_the_norm_of_the_pseudoscalar() {
    for (name, metric) in catalogue::all() {
        let pseudoscalar = algebra(&metric).pseudoscalar();
        assert_eq!(
            pseudoscalar.norm_squared(),
            metric.determinant(),
            "in {name}"
        );
    }
}

#[test]
fn blades_beyond_the_dimension_have_no_products() {
    let metric = catalogue::orthonormal(2, 0, 0);
    let beyond = Blade::new(0b100);
    for which in Product::ALL {
        assert_eq!(product(&metric, which, beyond, Blade::SCALAR), None);
        assert_eq!(
            product(&metric, which, Blade::SCALAR, Blade::new(u32::MAX)),
            None
        );
    }
    assert_eq!(dual(&metric, beyond), None);
    assert_eq!(undual(&metric, beyond), None);
    assert_eq!(
        right_complement(2, Blade::new(0b101)),
        (Blade::new(0b10), 1)
    );
    assert_eq!(
        left_complement(40, Blade::new(u32::MAX)),
        (Blade::SCALAR, 1)
    );
}

#[test]
fn overflow_is_reported() {
    let large = Rational::from_integer(1 << 70);
    let gram = vec![
        vec![large, Rational::ZERO],
        vec![Rational::ZERO, large.recip()],
    ];
    let metric = Metric::new(["u", "v"], gram).unwrap();
    let uv = Blade::new(0b11);
    assert_eq!(metric.determinant(), Rational::ONE);
    let square = product(&metric, Product::Geometric, uv, uv);
    assert_eq!(square, Some(vec![(Blade::SCALAR, -Rational::ONE)]));

    let diagonal = |entry| vec![vec![entry, Rational::ZERO], vec![Rational::ZERO, -entry]];
    assert_eq!(
        Metric::new(["u", "v"], diagonal(large)),
        Err(ga_core::MetricError::Overflow)
    );
    let zero = Rational::ZERO;
    let gram = vec![
        vec![large, zero, zero],
        vec![zero, large, zero],
        vec![zero, zero, zero],
    ];
    let degenerate = Metric::new(["u", "v", "w"], gram).unwrap();
    assert_eq!(degenerate.signature(), (2, 0, 1));
    assert_eq!(product(&degenerate, Product::Geometric, uv, uv), None);
}
