//! Floating-point numbers as a ring and a field.

use super::{Field, Scalar};
use crate::Narrowing;
use crate::convert::largest;

macro_rules! float {
    ($float:ident) => {
        impl Scalar for $float {
            const ZERO: Self = 0.0;
            const ONE: Self = 1.0;
            const HALF: Option<Self> = Some(0.5);

            fn from_integer(n: i64) -> Self {
                n as $float
            }

            // Elsewhere a fused operation is a call of a function, many times slower.
            #[cfg(all(feature = "std", any(target_feature = "fma", target_arch = "aarch64")))]
            #[inline(always)]
            fn plus_product(self, a: Self, b: Self) -> Self {
                a.mul_add(b, self)
            }

            #[cfg(all(feature = "std", any(target_feature = "fma", target_arch = "aarch64")))]
            #[inline(always)]
            fn minus_product(self, a: Self, b: Self) -> Self {
                (-a).mul_add(b, self)
            }
        }

        /// Zero, numbers whose reciprocal overflows, and what is not finite are not invertible.
        impl Field for $float {
            fn is_invertible(self) -> bool {
                self.is_finite() && self.recip().is_finite()
            }

            fn negligible_beside(coefficients: impl Iterator<Item = Self>) -> Self {
                largest(coefficients, |x| x.abs()) * Narrowing::TOLERANCE as $float
            }

            fn is_within(self, bound: Self) -> bool {
                bound.is_finite() && self.abs() <= bound
            }
        }
    };
}

float!(f32);
float!(f64);
