//! Laws of the algebra on random multivectors with exact coefficients.

use ga_core::dense::{Algebra, Dense};
use ga_core::{Metric, Rational};
use proptest::prelude::*;
use proptest::test_runner::TestRunner;

use crate::catalogue;

type Exact = Dense<Rational>;

/// Small integers, many of them zero, one for each coefficient of up to six dimensions.
fn coefficients() -> impl Strategy<Value = Vec<i128>> {
    proptest::collection::vec(prop_oneof![1 => Just(0), 1 => -3..=3_i128], 64)
}

fn multivector(algebra: &Algebra<Rational>, coefficients: &[i128]) -> Exact {
    let size = 1 << algebra.dimension();
    let coefficients = coefficients[..size].iter().copied();
    algebra
        .from_coefficients(coefficients.map(Rational::from_integer).collect())
        .unwrap()
}

fn vector(algebra: &Algebra<Rational>, coefficients: &[i128]) -> Exact {
    multivector(algebra, coefficients).grade(1)
}

/// How many random cases are tested: the products are slow.
fn cases(metric: &Metric) -> u32 {
    match metric.dimension() {
        0..=4 => 16,
        5 => 4,
        _ => 2,
    }
}

/// Tests a law of three multivectors in every metric of the catalogue.
fn in_every_metric(law: impl Fn(&Metric, &Algebra<Rational>, [&Exact; 3])) {
    for (name, metric) in catalogue::all() {
        let algebra = Algebra::new(&metric).unwrap();
        let cases = cases(&metric);
        let mut runner = TestRunner::new(ProptestConfig::with_cases(cases));
        let strategy = (coefficients(), coefficients(), coefficients());
        let outcome = runner.run(&strategy, |(a, b, c)| {
            let [a, b, c] = [&a, &b, &c].map(|list| multivector(&algebra, list));
            law(&metric, &algebra, [&a, &b, &c]);
            Ok(())
        });
        outcome.unwrap_or_else(|failure| panic!("in {name}: {failure}"));
    }
}

/// Tests a law of a versor that is the product of `factors` invertible vectors, and of two
/// multivectors.
fn of_versors(factors: usize, law: impl Fn(&Exact, [&Exact; 2])) {
    for (name, metric) in catalogue::all() {
        let algebra = Algebra::new(&metric).unwrap();
        let cases = cases(&metric);
        let mut runner = TestRunner::new(ProptestConfig::with_cases(cases));
        let vectors = proptest::collection::vec(coefficients(), factors);
        let outcome = runner.run(&(vectors, coefficients(), coefficients()), |(v, x, y)| {
            let mut versor = algebra.scalar(Rational::ONE);
            for list in &v {
                let factor = vector(&algebra, list);
                if factor.norm_squared() != Rational::ZERO {
                    versor = versor.geometric(&factor).unwrap();
                }
            }
            law(
                &versor,
                [&multivector(&algebra, &x), &multivector(&algebra, &y)],
            );
            Ok(())
        });
        outcome.unwrap_or_else(|failure| panic!("in {name}: {failure}"));
    }
}

#[test]
fn products_are_associative() {
    in_every_metric(|_, _, [a, b, c]| {
        let left = a.geometric(b).unwrap().geometric(c);
        assert_eq!(left, a.geometric(&b.geometric(c).unwrap()));
        let left = a.wedge(b).unwrap().wedge(c);
        assert_eq!(left, a.wedge(&b.wedge(c).unwrap()));
        let left = a.regressive(b).unwrap().regressive(c);
        assert_eq!(left, a.regressive(&b.regressive(c).unwrap()));
    });
}

#[test]
fn products_are_distributive() {
    in_every_metric(|_, _, [a, b, c]| {
        for which in ga_core::Product::ALL {
            let product = |x: &Exact, y: &Exact| x.product(which, y).unwrap();
            let sum = b.add(c).unwrap();
            let right = product(a, b).add(&product(a, c)).unwrap();
            assert_eq!(product(a, &sum), right, "{which:?}");
            let left = product(b, a).add(&product(c, a)).unwrap();
            assert_eq!(product(&sum, a), left, "{which:?}");
        }
    });
}

#[test]
fn contractions_are_adjoint_to_the_outer_product() {
    in_every_metric(|_, _, [a, b, c]| {
        let left = a.wedge(b).unwrap().left_contract(c);
        assert_eq!(left, a.left_contract(&b.left_contract(c).unwrap()));
        let right = a.right_contract(&b.wedge(c).unwrap());
        assert_eq!(right, a.right_contract(b).unwrap().right_contract(c));
    });
}

#[test]
fn involutions_reverse_or_keep_the_order() {
    in_every_metric(|_, _, [a, b, _]| {
        let product = a.geometric(b).unwrap();
        assert_eq!(Ok(product.reverse()), b.reverse().geometric(&a.reverse()));
        assert_eq!(
            Ok(product.conjugate()),
            b.conjugate().geometric(&a.conjugate())
        );
        assert_eq!(
            Ok(product.involute()),
            a.involute().geometric(&b.involute())
        );
        assert_eq!(a.reverse().involute(), a.conjugate());
    });
}

#[test]
fn duals_and_complements_are_undone() {
    in_every_metric(|metric, _, [a, b, _]| {
        assert_eq!(a, &a.right_complement().left_complement());
        assert_eq!(a, &a.left_complement().right_complement());
        assert_eq!(a.dual().is_err(), metric.is_degenerate());
        if let Ok(dual) = a.dual() {
            assert_eq!(a, &dual.undual());
            assert_eq!(Ok(a), a.undual().dual().as_ref());
            // (a ∧ b)* = a ⌋ b*
            let wedge_dual = a.wedge(b).unwrap().dual();
            assert_eq!(wedge_dual, a.left_contract(&b.dual().unwrap()));
        }
    });
}

/// The meet and the regressive product of blades differ by
/// (−1)^{[a(a−1)+b(b−1)+c(c−1)+n(n−1)]/2} with c = a + b − n.
#[test]
fn meet_and_regressive_product() {
    in_every_metric(|metric, _, [x, y, _]| {
        let n = metric.dimension() as u32;
        for a in 0..=n {
            for b in n - a..=n {
                let (x, y) = (x.grade(a), y.grade(b));
                let Ok(meet) = x.meet(&y) else { return };
                let c = a + b - n;
                let triangle = |k: u32| k * k.saturating_sub(1) / 2;
                let exponent = triangle(a) + triangle(b) + triangle(c) + triangle(n);
                let sign = if exponent % 2 == 0 { 1 } else { -1 };
                let regressive = x.regressive(&y).unwrap();
                assert_eq!(meet, regressive.scale(Rational::from_integer(sign)));
            }
        }
    });
}

#[test]
fn inverse_is_an_inverse() {
    in_every_metric(|metric, algebra, [a, _, _]| {
        // Six dimensions outgrow the integers unless most coefficients vanish.
        let a = if metric.dimension() > 5 {
            a.grade(0).add(&a.grade(1)).unwrap()
        } else {
            a.clone()
        };
        if let Ok(inverse) = a.inverse() {
            let one = algebra.scalar(Rational::ONE);
            assert_eq!(a.geometric(&inverse).unwrap(), one);
            assert_eq!(inverse.geometric(&a).unwrap(), one);
        }
    });
}

#[test]
fn versors_keep_grade_and_norm() {
    for factors in 1..=3 {
        of_versors(factors, |versor, [x, _]| {
            for grade in 0..=x.algebra().dimension() as u32 {
                let part = x.grade(grade);
                let image = versor.apply(&part).unwrap();
                assert_eq!(image, image.grade(grade));
                assert_eq!(image.norm_squared(), part.norm_squared());
            }
        });
    }
}

#[test]
fn versors_are_outermorphisms() {
    for factors in 1..=3 {
        of_versors(factors, |versor, [x, y]| {
            let apply = |x: &Exact| versor.apply(x).unwrap();
            assert_eq!(
                apply(&x.wedge(y).unwrap()),
                apply(x).wedge(&apply(y)).unwrap()
            );
            let contraction = apply(&x.left_contract(y).unwrap());
            assert_eq!(contraction, apply(x).left_contract(&apply(y)).unwrap());
        });
    }
}

/// Appendix A.4: the vectors (1, 2, 3) and (4, 5, 6).
#[test]
fn printed_example() {
    let space = Algebra::<i64>::integral(&catalogue::orthonormal(3, 0, 0)).unwrap();
    let a = space.vector(&[1, 2, 3]).unwrap();
    let b = space.vector(&[4, 5, 6]).unwrap();
    let product = a.geometric(&b).unwrap();
    assert_eq!(product.coefficients(), [32, 0, 0, -3, 0, -6, -3, 0]);
}
