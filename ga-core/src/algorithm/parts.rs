//! What the functions of bivectors and versors ask of the types they work on, and the parts that
//! a versor consists of.

use core::ops::{Add, Sub};

use crate::convert;
use crate::ops::{Element, Geometric, Inner, ScalarProduct, Wedge};
use crate::{Blade, Real, Scalar};

/// The general element whose scalar part is a number.
#[inline]
pub(super) fn scalar<M: Element>(value: M::Number) -> M {
    M::from_fn(|i| {
        if M::BLADES[i].0.mask() == 0 {
            value
        } else {
            M::Number::ZERO
        }
    })
}

/// A type that holds bivectors, with their outer squares in `Q`.
///
/// It may store other grades too, as the type of all even elements does; they are zero here.
pub trait Bivectors<Q>:
    Element
    + Geometric<Self::Number, Output = Self>
    + ScalarProduct<Self, Output = Self::Number>
    + Wedge<Self, Output: Into<Q>>
    + Add<Output = Self>
    + Sub<Output = Self>
{
}

impl<Q, A> Bivectors<Q> for A where
    A: Element
        + Geometric<Self::Number, Output = Self>
        + ScalarProduct<Self, Output = Self::Number>
        + Wedge<Self, Output: Into<Q>>
        + Add<Output = Self>
        + Sub<Output = Self>
{
}

/// A type that holds four-vectors, whose inner products with bivectors are bivectors of `A`.
pub trait Fourvectors<A>:
    Element
    + Geometric<Self::Number, Output = Self>
    + ScalarProduct<Self, Output = Self::Number>
    + Inner<A, Output: Into<A>>
    + Add<Output = Self>
    + Sub<Output = Self>
{
}

impl<A, Q> Fourvectors<A> for Q where
    Q: Element
        + Geometric<Self::Number, Output = Self>
        + ScalarProduct<Self, Output = Self::Number>
        + Inner<A, Output: Into<A>>
        + Add<Output = Self>
        + Sub<Output = Self>
{
}

/// A type that holds versors of the bivectors of `A` and the four-vectors of `Q`.
pub trait Versors<A, Q>: Element + From<A> + From<Q> + Add<Output = Self> {}

impl<A, Q, R> Versors<A, Q> for R where R: Element + From<A> + From<Q> + Add<Output = Self> {}

/// A versor by grades: scalar, bivector and four-vector.
#[derive(Clone, Copy, Debug)]
pub struct Parts<T, A, Q> {
    /// ⟨R⟩.
    pub scalar: T,
    /// ⟨R⟩₂.
    pub bivector: A,
    /// ⟨R⟩₄.
    pub fourth: Q,
}

/// The outer square A∧A of a bivector.
#[inline]
pub(super) fn outer_square<A: Bivectors<Q>, Q: Element>(bivector: A) -> Q {
    convert::grade(bivector.wedge(bivector).into(), 4)
}

/// The product V A of a four-vector and a bivector that commute: a bivector.
#[inline]
pub(super) fn turned<A: Element, Q: Fourvectors<A>>(fourth: Q, bivector: A) -> A {
    convert::grade(fourth.inner(bivector).into(), 2)
}

impl<T, A, Q> Parts<T, A, Q>
where
    T: Real,
    A: Bivectors<Q, Number = T>,
    Q: Fourvectors<A, Number = T>,
{
    /// The parts of an element; other grades are dropped.
    #[inline]
    pub fn of<R: Element<Number = T>>(versor: R) -> Self {
        Parts {
            scalar: convert::coefficient(&versor, Blade::SCALAR),
            bivector: convert::grade(convert::pick(versor), 2),
            fourth: convert::grade(convert::pick(versor), 4),
        }
    }

    /// The sum of the parts, if it is finite.
    #[inline]
    pub(super) fn finite_sum<R: Versors<A, Q, Number = T>>(self) -> Option<R> {
        let sum: R = self.sum();
        finite(sum)
    }

    /// The sum of the parts.
    #[inline]
    pub(super) fn sum<R: Versors<A, Q, Number = T>>(self) -> R {
        scalar::<R>(self.scalar) + R::from(self.bivector) + R::from(self.fourth)
    }
}

/// The element, if all its coefficients are finite.
#[inline]
pub(super) fn finite<M: Element<Number: Real>>(element: M) -> Option<M> {
    (0..M::BLADES.len())
        .all(|i| element.at(i).is_finite())
        .then_some(element)
}

/// The sum of a function of the coefficients.
#[inline]
pub(super) fn sum_of<M: Element>(
    element: &M,
    function: impl Fn(M::Number) -> M::Number,
) -> M::Number {
    (0..M::BLADES.len()).fold(M::Number::ZERO, |sum, i| sum + function(element.at(i)))
}
