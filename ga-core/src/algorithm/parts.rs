//! What the functions of bivectors and versors ask of the types they work on, and the parts that
//! a versor consists of.

use core::ops::{Add, Sub};

use crate::convert::{self, Places};
use crate::ops::{Element, Geometric, Inner, ScalarProduct, Wedge};
use crate::{Blade, Real, Scalar};

/// The general element whose scalar part is a number.
#[inline(always)]
pub(super) fn scalar<M: Element>(value: M::Number) -> M {
    M::from_fn(|i| {
        if M::BLADES[i].0.mask() == 0 {
            value
        } else {
            M::Number::ZERO
        }
    })
}

/// A type that holds bivectors.
///
/// It may store other grades too, as the type of all even elements does; they are zero here.
pub trait Bivectors:
    Element
    + Geometric<Self::Number, Output = Self>
    + ScalarProduct<Self, Output = Self::Number>
    + Wedge<Self, Output: Element<Number = Self::Number>>
    + Add<Output = Self>
    + Sub<Output = Self>
{
}

impl<A> Bivectors for A where
    A: Element
        + Geometric<Self::Number, Output = Self>
        + ScalarProduct<Self, Output = Self::Number>
        + Wedge<Self, Output: Element<Number = Self::Number>>
        + Add<Output = Self>
        + Sub<Output = Self>
{
}

/// A type that holds four-vectors, which have inner products with bivectors of `A`.
pub trait Fourvectors<A>:
    Element
    + Geometric<Self::Number, Output = Self>
    + ScalarProduct<Self, Output = Self::Number>
    + Inner<A, Output: Element<Number = Self::Number>>
    + Add<Output = Self>
    + Sub<Output = Self>
{
}

impl<A, Q> Fourvectors<A> for Q where
    Q: Element
        + Geometric<Self::Number, Output = Self>
        + ScalarProduct<Self, Output = Self::Number>
        + Inner<A, Output: Element<Number = Q::Number>>
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

/// The part of one grade, as a type that holds it.
#[inline(always)]
pub(super) fn part<M, Part>(element: M, grade: u32) -> Part
where
    M: Element<Number: Real>,
    Part: Element<Number = M::Number>,
{
    convert::grade(convert::pick(element), grade)
}

/// The outer square A∧A of a bivector.
#[inline(always)]
pub(super) fn outer_square<A: Bivectors<Number: Real>, Q>(bivector: A) -> Q
where
    Q: Element<Number = A::Number>,
{
    part(bivector.wedge(bivector), 4)
}

/// The product V A of a four-vector and a bivector that commute: a bivector.
#[inline(always)]
pub(super) fn turned<A, Q>(fourth: Q, bivector: A) -> A
where
    A: Element<Number = Q::Number>,
    Q: Fourvectors<A, Number: Real>,
{
    part(fourth.inner(bivector), 2)
}

impl<T, A, Q> Parts<T, A, Q>
where
    T: Real,
    A: Bivectors<Number = T>,
    Q: Fourvectors<A, Number = T>,
{
    /// The parts of an element; other grades are dropped.
    #[inline(always)]
    pub fn of<R: Element<Number = T>>(versor: R) -> Self {
        Parts {
            scalar: convert::coefficient(&versor, Blade::SCALAR),
            bivector: part(versor, 2),
            fourth: part(versor, 4),
        }
    }

    /// These parts in a place of their own: see [`copied`].
    #[inline(always)]
    pub(super) fn copied(&self) -> Self {
        Parts {
            scalar: self.scalar,
            bivector: copied(self.bivector),
            fourth: copied(self.fourth),
        }
    }

    /// Whether what is computed from this unit versor needs no proof that it leads back to it: the
    /// scalar is not below −1. Minus a boost is there, whose planes are left open: the rounding of
    /// its four-vector part would choose them, and not well.
    #[inline(always)]
    pub(super) fn is_plain(&self) -> bool {
        (-T::ONE - T::EPSILON.sqrt()).all_le(self.scalar)
    }

    /// Whether another versor is this one up to what an ill-conditioned function may lose: somewhat
    /// more than half of the digits of the largest coefficients.
    #[cfg_attr(all(feature = "inlined", not(debug_assertions)), inline(always))]
    pub(super) fn is_near(self, back: Self) -> bool {
        let difference = Parts {
            scalar: self.scalar - back.scalar,
            bivector: self.bivector - back.bivector,
            fourth: self.fourth - back.fourth,
        };
        let tolerance = T::EPSILON.sqrt() * T::from_integer(16);
        difference.sizes().all_le(self.sizes() * tolerance)
    }

    /// The sum of the absolute values of the coefficients.
    #[inline(always)]
    fn sizes(&self) -> T {
        self.scalar.abs() + sum_of_sizes(&self.bivector) + sum_of_sizes(&self.fourth)
    }

    /// The product of a versor with itself, whose four-vector and bivector commute.
    #[cfg_attr(all(feature = "inlined", not(debug_assertions)), inline(always))]
    pub(super) fn squared(self) -> Self {
        let Parts {
            scalar,
            bivector,
            fourth,
        } = self;
        let twice = scalar + scalar;
        let turned = turned(fourth, bivector);
        let squares = bivector.scalar_product(bivector) + fourth.scalar_product(fourth);
        Parts {
            scalar: scalar * scalar + squares,
            bivector: bivector.geometric(twice) + turned + turned,
            fourth: fourth.geometric(twice) + outer_square(bivector),
        }
    }

    /// The sum of the parts, if it is finite.
    #[inline(always)]
    pub(super) fn finite_sum<R: Versors<A, Q, Number = T>>(self) -> Option<R> {
        let sum: R = self.sum();
        finite(sum)
    }

    /// The sum of the parts.
    #[inline(always)]
    pub(super) fn sum<R: Versors<A, Q, Number = T>>(self) -> R {
        R::from_fn(|i| {
            let (blade, sign) = R::BLADES[i];
            let value = match blade.grade() {
                0 => self.scalar,
                2 => Places::<A, R>::at(i).read(&self.bivector),
                4 => Places::<Q, R>::at(i).read(&self.fourth),
                _ => T::ZERO,
            };
            convert::signed(sign, value)
        })
    }
}

/// The sum of multiples of two elements.
#[inline(always)]
pub(super) fn combined<A: Element>(one: A, factor: A::Number, other: A, share: A::Number) -> A {
    A::from_fn(|i| (one.at(i) * factor).plus_product(other.at(i), share))
}

/// The element, coefficient by coefficient.
///
/// What a call that is not inlined takes and gives stands in memory; a copy of its own leaves the
/// element itself, where that call is not made, in registers.
#[inline(always)]
pub(super) fn copied<M: Element>(element: M) -> M {
    M::from_fn(|i| element.at(i))
}

/// The element, if all its coefficients are finite.
#[inline(always)]
pub(super) fn finite<M: Element<Number: Real>>(element: M) -> Option<M> {
    // A number times zero is zero, and else not a number: one question for all coefficients. No
    // closures here and below: they would not be inlined into lanes.
    let mut zero = M::Number::ZERO;
    for i in 0..M::BLADES.len() {
        zero = zero.plus_product(element.at(i), M::Number::ZERO);
    }
    match zero.is_finite() {
        true => Some(element),
        false => None,
    }
}

/// The sum of the absolute values of the coefficients.
#[inline(always)]
pub(super) fn sum_of_sizes<M: Element<Number: Real>>(element: &M) -> M::Number {
    let mut sum = M::Number::ZERO;
    for i in 0..M::BLADES.len() {
        sum += element.at(i).abs();
    }
    sum
}

/// The sum of the squares of the coefficients.
#[inline(always)]
pub(super) fn sum_of_squares<M: Element<Number: Real>>(element: &M) -> M::Number {
    let mut sum = M::Number::ZERO;
    for i in 0..M::BLADES.len() {
        sum += element.at(i) * element.at(i);
    }
    sum
}
