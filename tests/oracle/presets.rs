//! The presets up to five dimensions: every type pair, every operation.

use ga::core::Metric;

use crate::conversions::{check_conversions, check_masks};
use crate::divisions::check_divisions;
use crate::operators::{check_operators, check_references, check_sums};
use crate::products::check_products;
use crate::unary::{check_duals, check_unary};
use crate::versors::check_versors;

ga::define_algebra!(R2);
ga::define_algebra!(R3);
ga::define_algebra!(R0_2);
ga::define_algebra!(R3_0_1);
ga::define_algebra!(R1_3);
ga::define_algebra!(R4_1);

/// All checks of a module that has every type of its list; duals where the metric has them.
macro_rules! check_everything {
    ($test:ident, $module:ident, $metric:expr, $units:expr, $types:tt, $($dual:ident)?) => {
        #[test]
        fn $test() {
            let oracle = oracle!($module $metric, units $units, $types);
            each_pair!(oracle, $module, $types, check_products);
            each_pair!(oracle, $module, $types, check_versors);
            // In small algebras everything that versors apply to has a matrix.
            let (all, matrices) = (oracle.applications.get(), oracle.matrices.get());
            assert!(matrices == all || oracle.dimension > 4 && matrices > 0);
            each_pair!(oracle, $module, $types, check_conversions);
            each_pair!(oracle, $module, $types, check_divisions);
            each_pair!(oracle, $module, $types, check_operators);
            each_pair!(oracle, $module, $types, check_references);
            each_pair!(oracle, $module, $types, check_sums);
            each_type!(oracle, $module, $types, check_unary);
            check_masks!(oracle, $module);
            type M = $module::Multivector<ga::core::Rational>;
            type Even = $module::Even<ga::core::Rational>;
            type Odd = $module::Odd<ga::core::Rational>;
            crate::laws::products::<M>(&oracle);
            crate::laws::versors::<Even, M>(&oracle);
            crate::laws::versors::<Odd, M>(&oracle);
            $(
                each_type!(oracle, $module, $types, $dual);
                crate::laws::duals::<M>(&oracle);
            )?
            assert!(!oracle.degenerate || oracle.algebra.pseudoscalar().dual().is_err());
        }
    };
}

pub(crate) use check_everything;

fn signature(positive: usize, negative: usize, null: usize) -> Metric {
    Metric::from_signature(positive, negative, null).expect("few dimensions")
}

check_everything! { plane, r2, signature(2, 0, 0), [],
[Scalar Vector Bivector Even Odd Multivector], check_duals }
check_everything! { space, r3, signature(3, 0, 0), [],
[Scalar Vector Bivector Trivector Even Odd Multivector], check_duals }
check_everything! { quaternions, r0_2, signature(0, 2, 0), [],
[Scalar Vector Bivector Even Odd Multivector], check_duals }
check_everything! { projective, r3_0_1, signature(3, 0, 1), [],
[Scalar Vector Bivector Trivector Quadvector Even Odd Multivector], }
check_everything! { spacetime, r1_3, signature(1, 3, 0), [],
[Scalar Vector Bivector Trivector Quadvector Even Odd Multivector], check_duals }
check_everything! { conformal_orthonormal, r4_1, signature(4, 1, 0), [],
[Scalar Vector Bivector Trivector Quadvector Pentavector Even Odd Multivector], check_duals }
