//! A metric that no preset covers: oblique vectors with a rational Gram matrix, fields in odd
//! orders and orientations, fixed coefficients, and unit types.

use ga::core::{Metric, Rational};

use crate::conversions::{check_conversions, check_masks};
use crate::divisions::check_divisions;
use crate::operators::{check_operators, check_references, check_sums};
use crate::presets::check_everything;
use crate::products::check_products;
use crate::unary::{check_duals, check_unary};
use crate::versors::check_versors;

ga::define_algebra! {
    /// Three oblique vectors.
    pub mod oblique: R2_1 {
        basis { e1, e2, e3 }
        metric { e1^2 = 2, e2^2 = -1, e3^2 = 3, e1.e2 = 1, e2.e3 = 1/2 }
        types {
            Vector { e3, e1, e2 }
            Flat { e2, e1 }
            Weighted { e2 = -2, e1, e3 }
            Sheared { e31 = 1/2, e21, e23 }
            Bivector { e31, e23, e12 }
            Plane { e32, e31 }
            Upward { e13 = -1/2, e12 }
            Narrow { e2 = -2, e3 }
            Volume { e321 }
            Shifted { 1 = 3, e12 }
            Turn { e21, 1 }
            Mixed { 1, e312, e2 }
            #[unit] Spinor { e31, 1, e23, e12 }
        }
    }
}

fn metric() -> Metric {
    let gram = [[4, 2, 0], [2, -2, 1], [0, 1, 6]].map(|row| row.map(|x| Rational::new(x, 2)));
    Metric::new(["e1", "e2", "e3"], gram.map(Vec::from).to_vec()).expect("symmetric")
}

check_everything! { rational_metric, oblique, metric(), ["Spinor"],
[Vector Flat Weighted Sheared Bivector Plane Upward Narrow Volume Shifted Turn Mixed Spinor
 Scalar Even Odd Multivector], check_duals }
