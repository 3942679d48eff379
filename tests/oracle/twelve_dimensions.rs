//! A sparse algebra of twelve dimensions: a product exists exactly where a declared type holds
//! it.

use ga::core::ops::Element;
use ga::core::{Metric, Rational};

use crate::conversions::check_conversions;
use crate::divisions::check_divisions;
use crate::operators::{check_operators, check_references, check_sums};
use crate::products::check_products;
use crate::unary::check_unary;
use crate::versors::check_versors;

ga::define_algebra! {
    /// Twelve vectors, of which the types use some.
    pub mod r10_1_1: R10_1_1 {
        types {
            Corner { e12, e1, e9 }
            Point { e11 = 1, e1, e2 }
            Free { e11, e1, e2 }
            Turn { 1, e2^e1, e1^e11 }
            Sum { 1, e2^e1, e1^e11, e2^e11 }
            Top { e1^e2^e3^e4^e5^e6^e7^e8^e9^e10^e11^e12 }
        }
    }
}

#[test]
fn sparse_types() {
    let metric = Metric::from_signature(10, 1, 1).expect("twelve dimensions");
    let oracle = oracle!(r10_1_1 metric, units [], [Corner Point Free Turn Sum Top Scalar]);
    macro_rules! all {
        ($each:ident, $check:ident) => {
            $each!(oracle, r10_1_1, [Corner Point Free Turn Sum Top Scalar], $check);
        };
    }
    all!(each_pair, check_products);
    all!(each_pair, check_versors);
    all!(each_pair, check_conversions);
    all!(each_pair, check_divisions);
    all!(each_pair, check_operators);
    all!(each_pair, check_references);
    all!(each_pair, check_sums);
    all!(each_type, check_unary);
}

#[test]
fn spelling_and_fixed_coefficients() {
    // e12 is the last basis vector, and the plane of the first two is spelled with a wedge.
    let last = r10_1_1::Corner::new(1.0, 0.0, 0.0);
    assert_eq!(last.to_string(), "e12");
    assert_eq!(r10_1_1::Corner::<f64>::BLADES[0].0.mask(), 1 << 11);

    let [x, y] = [3, 5].map(Rational::from);
    let kept: r10_1_1::Free<Rational> = r10_1_1::Point::new(x, y) - r10_1_1::Point::new(y, x);
    assert_eq!(kept.e11, Rational::from(0));
}
