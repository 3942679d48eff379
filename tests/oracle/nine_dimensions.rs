//! A sparse algebra of nine dimensions with sandwiches too long to compose: the products in
//! between have no types, so the whole is unrolled, and inverses beyond the reverse.

use ga::core::Metric;

use crate::conversions::check_conversions;
use crate::divisions::check_divisions;
use crate::operators::{check_operators, check_references, check_sums};
use crate::products::check_products;
use crate::unary::check_unary;
use crate::versors::check_versors;

ga::define_algebra! {
    /// Nine vectors, of whose planes the types use some.
    pub mod r8_1: R8_1 {
        types {
            Vector { e1, e2, e3, e4, e5, e6, e7, e8, e9 }
            Planes { e12, e34, e56, e78 }
            Turns { 1, e12, e34, e1^e2^e3^e4 }
            Fan { 1, e12, e13, e14, e15, e16, e17 }
            Bivector {
                e12, e13, e14, e15, e16, e17, e23, e24, e25, e26, e27, e34, e35, e36, e37, e45,
                e46, e47, e56, e57, e67,
            }
        }
    }
}

#[test]
fn long_sandwiches() {
    let metric = Metric::from_signature(8, 1, 0).expect("nine dimensions");
    let oracle = oracle!(r8_1 metric, units [], [Vector Planes Turns Fan Bivector Scalar]);
    macro_rules! all {
        ($each:ident, $check:ident) => {
            $each!(oracle, r8_1, [Vector Planes Turns Fan Bivector Scalar], $check);
        };
    }
    all!(each_pair, check_products);
    all!(each_pair, check_versors);
    all!(each_pair, check_conversions);
    all!(each_pair, check_sums);
    // The sums of planes have no inverse among the types, and nothing can be divided by them.
    each_pair!(oracle, r8_1, [Vector Turns Fan Scalar], check_operators);
    each_pair!(oracle, r8_1, [Vector Turns Fan Scalar], check_references);
    each_pair!(oracle, r8_1, [Vector Turns Fan Scalar], check_divisions);
    each_type!(oracle, r8_1, [Vector Turns Fan Scalar], check_unary);
}
