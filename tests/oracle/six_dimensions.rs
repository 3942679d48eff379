//! The presets of six dimensions, whose longest products are loops.

use ga::core::Metric;

use crate::conversions::{check_conversions, check_masks};
use crate::divisions::check_divisions;
use crate::operators::{check_operators, check_references, check_sums};
use crate::presets::check_everything;
use crate::products::check_products;
use crate::unary::{check_duals, check_unary};
use crate::versors::check_versors;

ga::define_algebra!(R6);
ga::define_algebra!(R3_3);
ga::define_algebra!(R4_2);
ga::define_algebra!(R2_4);

fn signature(positive: usize, negative: usize) -> Metric {
    Metric::from_signature(positive, negative, 0).expect("six dimensions")
}

check_everything! { euclidean, r6, signature(6, 0), [],
[Scalar Vector Bivector Trivector Quadvector Pentavector Hexavector Even Odd Multivector], check_duals }
check_everything! { split, r3_3, signature(3, 3), [],
[Scalar Vector Bivector Trivector Quadvector Pentavector Hexavector Even Odd Multivector], check_duals }
check_everything! { conformal_spacetime, r4_2, signature(4, 2), [],
[Scalar Vector Bivector Trivector Quadvector Pentavector Hexavector Even Odd Multivector], check_duals }
check_everything! { lie_spheres, r2_4, signature(2, 4), [],
[Scalar Vector Bivector Trivector Quadvector Pentavector Hexavector Even Odd Multivector], check_duals }
