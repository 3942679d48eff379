//! SIMD lanes: several numbers that undergo the same operations.
//!
//! Ring operations, quotients and absolute values act on all lanes at once; the other functions
//! run lane by lane, so that a lane at the edge of a domain leaves the others alone.

use wide::{f32x4, f32x8, f64x2, f64x4};

#[cfg(any(feature = "std", feature = "libm"))]
use super::Real;
use super::{Field, Scalar};
use crate::Narrowing;
use crate::convert::largest;

macro_rules! lanes {
    ($lanes:ident, $float:ident, $count:literal) => {
        impl Scalar for $lanes {
            const ZERO: Self = $lanes::new([0.0; $count]);
            const ONE: Self = $lanes::new([1.0; $count]);

            fn from_integer(n: i64) -> Self {
                $lanes::new([n as $float; $count])
            }

            #[inline(always)]
            fn plus_product(self, a: Self, b: Self) -> Self {
                a.mul_add(b, self)
            }

            #[inline(always)]
            fn minus_product(self, a: Self, b: Self) -> Self {
                a.mul_neg_add(b, self)
            }
        }

        impl Field for $lanes {
            fn is_invertible(self) -> bool {
                self.to_array().into_iter().all(Field::is_invertible)
            }

            fn negligible_beside(coefficients: impl Iterator<Item = Self>) -> Self {
                let tolerance = Narrowing::TOLERANCE as $float;
                largest(coefficients, $lanes::abs) * $lanes::new([tolerance; $count])
            }

            fn is_within(self, bound: Self) -> bool {
                let mut pairs = self.to_array().into_iter().zip(bound.to_array());
                pairs.all(|(value, bound)| value.is_within(bound))
            }
        }

        #[cfg(any(feature = "std", feature = "libm"))]
        impl Real for $lanes {
            const PI: Self = $lanes::new([core::$float::consts::PI; $count]);
            const EPSILON: Self = $lanes::new([core::primitive::$float::EPSILON; $count]);

            fn from_f64(value: f64) -> Self {
                $lanes::new([value as $float; $count])
            }

            fn at_value(self, value: Self) -> Self {
                value
            }

            fn abs(self) -> Self {
                $lanes::abs(self)
            }

            fn sqrt(self) -> Self {
                $lanes::new(self.to_array().map(Real::sqrt))
            }

            fn sin_cos(self) -> (Self, Self) {
                let pairs = self.to_array().map(Real::sin_cos);
                (
                    $lanes::new(pairs.map(|(sin, _)| sin)),
                    $lanes::new(pairs.map(|(_, cos)| cos)),
                )
            }

            fn atan2(self, x: Self) -> Self {
                let (y, x) = (self.to_array(), x.to_array());
                $lanes::new(core::array::from_fn(|lane| Real::atan2(y[lane], x[lane])))
            }

            fn exp(self) -> Self {
                $lanes::new(self.to_array().map(Real::exp))
            }

            fn ln(self) -> Self {
                $lanes::new(self.to_array().map(Real::ln))
            }

            fn cosh_sinhc(self) -> (Self, Self) {
                let pairs = self.to_array().map(Real::cosh_sinhc);
                (
                    $lanes::new(pairs.map(|(cosh, _)| cosh)),
                    $lanes::new(pairs.map(|(_, sinhc)| sinhc)),
                )
            }

            fn log_factor(self, square: Self) -> Option<Self> {
                let mut factors = self.to_array();
                for (factor, square) in factors.iter_mut().zip(square.to_array()) {
                    *factor = factor.log_factor(square)?;
                }
                Some($lanes::new(factors))
            }

            fn is_finite(self) -> bool {
                self.to_array().into_iter().all(Real::is_finite)
            }

            fn all_le(self, other: Self) -> bool {
                let mut pairs = self.to_array().into_iter().zip(other.to_array());
                pairs.all(|(value, bound)| value <= bound)
            }

            fn select_le(self, bound: Self, then: Self, otherwise: Self) -> Self {
                let (value, bound) = (self.to_array(), bound.to_array());
                let (then, otherwise) = (then.to_array(), otherwise.to_array());
                $lanes::new(core::array::from_fn(|lane| {
                    value[lane].select_le(bound[lane], then[lane], otherwise[lane])
                }))
            }
        }
    };
}

lanes!(f32x4, f32, 4);
lanes!(f32x8, f32, 8);
lanes!(f64x2, f64, 2);
lanes!(f64x4, f64, 4);
