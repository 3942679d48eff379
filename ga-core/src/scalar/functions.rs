//! Elementary functions of lanes, from arithmetic and polynomials alone.

pub(super) mod circular;
pub(super) mod exponential;
pub(super) mod inverse_tangent;
pub(super) mod logarithm;
mod polynomial;
pub(super) mod rotors;

use super::lanes::Lanes;
use super::precision::Precision;

/// The nearest integers, even ones of two, up to half of the largest number with halves.
#[inline(always)]
fn nearest_integer<L: Lanes>(x: L) -> L {
    let large = L::splat(L::Float::ROUNDING);
    (x + large) - large
}

/// A constant given in double precision, rounded.
#[inline(always)]
fn constant<L: Lanes>(value: f64) -> L {
    L::splat(L::Float::rounded(value))
}

/// 1 where an integer is odd, 0 where it is even.
#[inline(always)]
fn parity<L: Lanes>(integer: L) -> L {
    let half = nearest_integer(integer * constant(0.5));
    (integer - (half + half)).magnitude()
}

/// Where a number is not one.
#[inline(always)]
fn is_not_a_number<L: Lanes>(x: L) -> L::Mask {
    !x.is_at_most(x)
}
