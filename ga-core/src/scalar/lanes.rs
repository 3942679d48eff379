//! What the functions ask of numbers that are computed several at a time: one trait for lanes of
//! every width and target, and for a number alone.

use core::ops::{BitAnd, BitOr, Not};

use super::precision::Precision;
use super::{Computation, Field};

/// Numbers of one precision that undergo the same operations: SIMD lanes, or a number alone.
///
/// With these few operations a type is a [`Real`](super::Real) number: roots and transcendental
/// functions follow from them without a branch that lanes could take differently. A lane is
/// computed as a number alone would be, whatever its neighbours hold.
///
/// Implemented for `f32` and `f64`, and for the lanes of `wide` (feature `wide`).
pub trait Lanes: Field {
    /// The number that each lane holds.
    type Float: Precision;
    /// The outcome of a comparison, lane by lane.
    type Mask: Copy
        + BitAnd<Output = Self::Mask>
        + BitOr<Output = Self::Mask>
        + Not<Output = Self::Mask>;

    /// The circle constant π.
    const PI: Self;
    /// The distance from 1 to the next larger number.
    const EPSILON: Self;

    /// The same number in every lane.
    fn splat(value: Self::Float) -> Self;
    /// A function of each lane by itself, for what has no instruction.
    fn map(self, function: impl Fn(Self::Float) -> Self::Float) -> Self;
    /// A function of the lanes of both, each by itself.
    fn zip(self, other: Self, function: impl Fn(Self::Float, Self::Float) -> Self::Float) -> Self;

    /// Where `self < other`; nowhere for what is not a number.
    fn is_less(self, other: Self) -> Self::Mask;
    /// Where `self ≤ other`; nowhere for what is not a number.
    fn is_at_most(self, other: Self) -> Self::Mask;
    /// Whether a comparison holds in every lane.
    fn all(mask: Self::Mask) -> bool;
    /// Whether a comparison holds in any lane.
    fn any(mask: Self::Mask) -> bool;
    /// `then` where the comparison holds, `otherwise` elsewhere.
    fn select(mask: Self::Mask, then: Self, otherwise: Self) -> Self;

    /// The absolute value.
    fn magnitude(self) -> Self;
    /// The absolute value with the sign of another number, that of zeros included.
    fn with_sign_of(self, sign: Self) -> Self;
    /// The square root, rounded correctly; of a negative value not a number.
    fn square_root(self) -> Self;
    /// 2ⁿ of an integer n whose power is a normal number; of others without a meaning.
    fn power_of_two(self) -> Self;
    /// Mantissa m and exponent n of a positive normal number m 2ⁿ, 1 ≤ m < 2; of others without a
    /// meaning.
    fn mantissa_and_exponent(self) -> (Self, Self);

    /// A computation in a function of its own, with the instructions of these lanes.
    #[inline(always)]
    fn outlined<C: Computation>(computation: C) -> C::Output {
        super::outlined(computation)
    }
}

/// A number alone is one lane.
macro_rules! single_lane {
    ($float:ident $exponent_bias:literal) => {
        impl Lanes for $float {
            type Float = $float;
            type Mask = bool;

            const PI: Self = core::$float::consts::PI;
            const EPSILON: Self = core::primitive::$float::EPSILON;

            #[inline(always)]
            fn splat(value: $float) -> Self {
                value
            }

            #[inline(always)]
            fn map(self, function: impl Fn($float) -> $float) -> Self {
                function(self)
            }

            #[inline(always)]
            fn zip(self, other: Self, function: impl Fn($float, $float) -> $float) -> Self {
                function(self, other)
            }

            #[inline(always)]
            fn is_less(self, other: Self) -> bool {
                self < other
            }

            #[inline(always)]
            fn is_at_most(self, other: Self) -> bool {
                self <= other
            }

            #[inline(always)]
            fn all(mask: bool) -> bool {
                mask
            }

            #[inline(always)]
            fn any(mask: bool) -> bool {
                mask
            }

            #[inline(always)]
            fn select(mask: bool, then: Self, otherwise: Self) -> Self {
                if mask { then } else { otherwise }
            }

            #[inline(always)]
            fn magnitude(self) -> Self {
                self.abs()
            }

            #[inline(always)]
            fn with_sign_of(self, sign: Self) -> Self {
                self.copysign(sign)
            }

            #[inline(always)]
            fn square_root(self) -> Self {
                super::elementary::Elementary::sqrt(self)
            }

            #[inline(always)]
            fn power_of_two(self) -> Self {
                // In this sum the exponent stands in the last bits.
                let biased = self + (Self::ROUNDING + $exponent_bias);
                Self::from_bits(biased.to_bits() << (Self::MANTISSA_DIGITS - 1))
            }

            #[inline(always)]
            fn mantissa_and_exponent(self) -> (Self, Self) {
                let bits = self.to_bits();
                let exponent = bits >> (Self::MANTISSA_DIGITS - 1);
                let one = Self::to_bits(1.0);
                let mantissa = bits & ((1 << (Self::MANTISSA_DIGITS - 1)) - 1);
                let shifted = Self::from_bits(Self::to_bits(Self::ROUNDING) | exponent);
                (
                    Self::from_bits(mantissa | one),
                    shifted - (Self::ROUNDING + $exponent_bias),
                )
            }
        }
    };
}

single_lane!(f32 127.0);
single_lane!(f64 1023.0);
