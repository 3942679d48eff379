//! The principal square root of a unit versor in any dimension: the polar factor of 1 + R by
//! Newton's iteration.

use core::ops::{Add, Sub};

use super::inverse::{adjugate, adjugate_products};
use super::parts::{scalar, sum_of_sizes};
use crate::ops::{Element, Geometric, Reverse};
use crate::{Field, Real, Scalar};

/// How many steps the iteration may take: each halves what is far too large and doubles what is
/// far too small, and the last few square the error.
pub const MOST_STEPS: usize = 128;
/// How many steps improve an inverse.
const IMPROVEMENTS: usize = 2;

/// How many products a step takes at most, on a type of `blades` blades: the excess, and an
/// inverse with two products for each improvement.
pub const fn step_products(blades: usize) -> usize {
    1 + adjugate_products(blades) + 2 * IMPROVEMENTS
}

/// A type that holds a whole algebra of even elements.
pub trait Evens:
    Element<Number: Real>
    + Geometric<Self, Output: Into<Self>>
    + Geometric<Self::Number, Output = Self>
    + Reverse<Output = Self>
    + Add<Output = Self>
    + Sub<Output = Self>
{
}

impl<M> Evens for M where
    M: Element<Number: Real>
        + Geometric<M, Output: Into<M>>
        + Geometric<M::Number, Output = M>
        + Reverse<Output = M>
        + Add<Output = M>
        + Sub<Output = M>
{
}

/// What the comparisons of an iterated result neglect, relative to what is compared.
pub(super) fn tolerance<T: Real>() -> T {
    T::EPSILON.sqrt()
}

/// The product, as the type of its operands.
pub(super) fn times<M: Evens>(a: M, b: M) -> M {
    a.geometric(b).into()
}

/// The principal square root `√R = X (X̃ X)^(−1/2)` of an even element with `R R̃ = 1`, where
/// X = 1 + R: its polar factor (2.37, 2.38).
///
/// `None` where the iteration finds none, as for R = −1 and minus a boost.
pub(super) fn principal_root<M: Evens>(unit: M) -> Option<M> {
    polar_factor(unit + scalar(M::Number::ONE))
}

/// The limit U of `X ← (X + X̃⁻¹)/2` (Higham, *Functions of Matrices*, 2008, section 8.3), near it
/// of `X ← X (3 − X̃ X)/2`, which needs no inverse: `Ũ U = 1`. `None` where the iteration does
/// not settle.
pub(super) fn polar_factor<M: Evens>(element: M) -> Option<M> {
    let half = M::Number::from_ratio(1, 2);
    let one = scalar::<M>(M::Number::ONE);
    let mut x = element;
    let mut before = M::Number::ONE;
    for _ in 0..MOST_STEPS {
        let excess = times(x.reverse(), x) - one;
        let size = sum_of_sizes(&excess);
        if !size.is_finite() {
            return None;
        }
        if size.all_le(M::Number::from_ratio(1, 4)) {
            let next = x - times(x, excess).geometric(half);
            // So near, each step squares the excess, unless it consists of rounding.
            if size.all_le(tolerance()) && before.all_le(size + size) {
                return Some(next);
            }
            x = next;
        } else {
            x = (x + inverse(x.reverse())?).geometric(half);
        }
        before = size;
    }
    None
}

/// The inverse of an even element, with two steps `Z ← Z (2 − X Z)` against the rounding of the
/// determinant's recursion.
fn inverse<M: Evens>(x: M) -> Option<M> {
    let (adjugate, determinant) = adjugate(x, M::BLADES.len());
    if !determinant.is_invertible() {
        return None;
    }
    let two = scalar::<M>(M::Number::from_integer(2));
    let mut inverse = adjugate.geometric(M::Number::ONE / determinant);
    for _ in 0..IMPROVEMENTS {
        inverse = times(inverse, two - times(x, inverse));
    }
    Some(inverse)
}
