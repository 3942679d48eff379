//! A sparse algebra of twelve dimensions: a product exists exactly where a declared type holds
//! it.

use ga::core::ops::Element;
use ga::core::{Metric, Rational};

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
    each_pair!(oracle, r10_1_1, [Corner Point Free Turn Sum Top Scalar], check_products);

    // e12 is the last basis vector, and the plane of the first two is spelled with a wedge.
    let last = r10_1_1::Corner::new(1.0, 0.0, 0.0);
    assert_eq!(last.to_string(), "e12");
    assert_eq!(r10_1_1::Corner::<f64>::BLADES[0].0.mask(), 1 << 11);

    let turn = r10_1_1::Turn::new(Rational::from(2), Rational::from(-1), Rational::from(0));
    let free = r10_1_1::Free::new(Rational::from(3), Rational::from(5), Rational::from(7));
    let (v, x) = (oracle.value(&turn), oracle.value(&free));
    let expected = oracle.dense(&v).apply(&oracle.dense(&x)).expect("a rotor");
    let image: r10_1_1::Free<Rational> = turn.apply(free);
    oracle.same(
        "apply",
        &[&v, &x],
        &oracle.value(&image),
        &expected.coefficients().to_vec(),
    );
    let kept: r10_1_1::Free<Rational> =
        r10_1_1::Point::new(free.e1, free.e2) - r10_1_1::Point::new(free.e2, free.e1);
    assert_eq!(kept.e11, Rational::from(0));
}
