//! Floating-point numbers as a ring and a field.

use super::{Field, Scalar};
use crate::Narrowing;
use crate::convert::largest;

macro_rules! float {
    ($float:ident) => {
        impl Scalar for $float {
            const ZERO: Self = 0.0;
            const ONE: Self = 1.0;

            fn from_integer(n: i64) -> Self {
                n as $float
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
