//! The lanes of `wide`, as they are.

use wide::{f32x4, f32x8, f32x16, f64x2, f64x4, f64x8};

#[cfg(any(feature = "std", feature = "libm"))]
use super::lanes::Lanes;
use super::{Field, Scalar};
use crate::Narrowing;
use crate::convert::largest;

macro_rules! lanes {
    ($lanes:ident, $float:ident, $count:literal) => {
        impl Scalar for $lanes {
            const ZERO: Self = $lanes::new([0.0; $count]);
            const ONE: Self = $lanes::new([1.0; $count]);
            const HALF: Option<Self> = Some($lanes::new([0.5; $count]));

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
        impl Lanes for $lanes {
            type Float = $float;
            type Mask = $lanes;

            const PI: Self = $lanes::new([core::$float::consts::PI; $count]);
            const EPSILON: Self = $lanes::new([core::primitive::$float::EPSILON; $count]);

            #[inline(always)]
            fn splat(value: $float) -> Self {
                $lanes::new([value; $count])
            }

            #[inline(always)]
            fn map(self, function: impl Fn($float) -> $float) -> Self {
                $lanes::new(self.to_array().map(function))
            }

            #[inline(always)]
            fn zip(self, other: Self, function: impl Fn($float, $float) -> $float) -> Self {
                let (own, other) = (self.to_array(), other.to_array());
                $lanes::new(core::array::from_fn(|lane| {
                    function(own[lane], other[lane])
                }))
            }

            #[inline(always)]
            fn is_less(self, other: Self) -> Self {
                self.simd_lt(other)
            }

            #[inline(always)]
            fn is_at_most(self, other: Self) -> Self {
                self.simd_le(other)
            }

            #[inline(always)]
            fn all(mask: Self) -> bool {
                $lanes::all(mask)
            }

            #[inline(always)]
            fn any(mask: Self) -> bool {
                $lanes::any(mask)
            }

            #[inline(always)]
            fn select(mask: Self, then: Self, otherwise: Self) -> Self {
                mask.select(then, otherwise)
            }

            #[inline(always)]
            fn magnitude(self) -> Self {
                $lanes::abs(self)
            }

            #[inline(always)]
            fn with_sign_of(self, sign: Self) -> Self {
                let signs = $lanes::new([-0.0; $count]);
                $lanes::abs(self) | (sign & signs)
            }

            #[inline(always)]
            fn square_root(self) -> Self {
                $lanes::sqrt(self)
            }

            #[inline(always)]
            fn power_of_two(self) -> Self {
                self.map(Lanes::power_of_two)
            }

            #[inline(always)]
            fn mantissa_and_exponent(self) -> (Self, Self) {
                (
                    self.map(|x| x.mantissa_and_exponent().0),
                    self.map(|x| x.mantissa_and_exponent().1),
                )
            }
        }
    };
}

lanes!(f32x4, f32, 4);
lanes!(f32x8, f32, 8);
lanes!(f32x16, f32, 16);
lanes!(f64x2, f64, 2);
lanes!(f64x4, f64, 4);
lanes!(f64x8, f64, 8);
