//! What an operation is, for all lanes and for those of one target.

pub mod fallible;
pub mod named;

use ga_core::{Element, Scalar};

use crate::lanes::Lanes;
use crate::number::Number;
#[cfg(target_arch = "x86_64")]
use crate::number::{Wide, Widest};

/// A function of one element, written once for all lanes; see [`Batch::map`](crate::Batch::map).
///
/// It wants `#[inline(always)]`, as a [`Kernel`](crate::Kernel) does.
pub trait Map<X: Element<Number: Number>>: Sync {
    /// The type of the values.
    type Output: Element<Number = X::Number>;
    /// The value.
    fn call<L: Lanes<X::Number>>(&self, x: X::Over<L>) -> <Self::Output as Element>::Over<L>;
}

/// A function of two elements, written once for all lanes; see
/// [`Batch::zip_map`](crate::Batch::zip_map).
///
/// It wants `#[inline(always)]`, as a [`Kernel`](crate::Kernel) does.
pub trait ZipMap<X: Element<Number: Number>, Y: Element<Number = X::Number>>: Sync {
    /// The type of the values.
    type Output: Element<Number = X::Number>;
    /// The value.
    fn call<L: Lanes<X::Number>>(
        &self,
        x: X::Over<L>,
        y: Y::Over<L>,
    ) -> <Self::Output as Element>::Over<L>;
}

/// The type of an operation's values.
pub trait Values<X, Y> {
    /// The type.
    type Output: Element;
    /// Whether it is too long to be inlined into the function of a target.
    const LONG: bool = false;
}

/// An operation on two elements in lanes `L`. One on a single element has it on the right, and a
/// number that is not read on the left.
pub trait Operation<X: Element, Y: Element, L: Scalar>: Values<X, Y> {
    /// What an operation wants to know of the left operand: itself, or what follows from it alone,
    /// and is kept where one element is on the left of all.
    type Left: Copy;
    /// What it wants to know of this one.
    fn left(x: X::Over<L>) -> Self::Left;
    /// The value.
    fn call(&self, x: Self::Left, y: Y::Over<L>) -> <Self::Output as Element>::Over<L>;
}

/// An operation that exists for the lanes of every target.
#[cfg(target_arch = "x86_64")]
#[diagnostic::on_unimplemented(
    message = "these batches have no such operation",
    label = "not generated for the types of the elements"
)]
pub trait Everywhere<X: Element, Y: Element, F: Number>:
    Values<X, Y, Output: Element<Number = F>>
    + Operation<X, Y, F::Portable>
    + Operation<X, Y, Wide<F>>
    + Operation<X, Y, Widest<F>>
    + Sync
{
}
#[cfg(target_arch = "x86_64")]
impl<X: Element, Y: Element, F: Number, O> Everywhere<X, Y, F> for O where
    O: Values<X, Y, Output: Element<Number = F>>
        + Operation<X, Y, F::Portable>
        + Operation<X, Y, Wide<F>>
        + Operation<X, Y, Widest<F>>
        + Sync
{
}

/// An operation that exists for the lanes of every target.
#[cfg(not(target_arch = "x86_64"))]
pub trait Everywhere<X: Element, Y: Element, F: Number>:
    Values<X, Y, Output: Element<Number = F>> + Operation<X, Y, F::Portable> + Sync
{
}
#[cfg(not(target_arch = "x86_64"))]
impl<X: Element, Y: Element, F: Number, O> Everywhere<X, Y, F> for O where
    O: Values<X, Y, Output: Element<Number = F>> + Operation<X, Y, F::Portable> + Sync
{
}

/// A [`Map`] as an operation.
pub struct Mapping<'k, K>(pub &'k K);

impl<X: Element<Number: Number>, K: Map<X>> Values<X::Number, X> for Mapping<'_, K> {
    type Output = K::Output;
}

impl<X, L, K> Operation<X::Number, X, L> for Mapping<'_, K>
where
    X: Element<Number: Number>,
    L: Lanes<X::Number>,
    K: Map<X>,
{
    type Left = L;

    #[inline(always)]
    fn left(x: L) -> L {
        x
    }

    #[inline(always)]
    fn call(&self, _: L, x: X::Over<L>) -> <K::Output as Element>::Over<L> {
        self.0.call::<L>(x)
    }
}

/// A [`ZipMap`] as an operation.
pub struct Zipping<'k, K>(pub &'k K);

impl<X, Y, K> Values<X, Y> for Zipping<'_, K>
where
    X: Element<Number: Number>,
    Y: Element<Number = X::Number>,
    K: ZipMap<X, Y>,
{
    type Output = K::Output;
}

impl<X, Y, L, K> Operation<X, Y, L> for Zipping<'_, K>
where
    X: Element<Number: Number>,
    Y: Element<Number = X::Number>,
    L: Lanes<X::Number>,
    K: ZipMap<X, Y>,
{
    type Left = X::Over<L>;

    #[inline(always)]
    fn left(x: X::Over<L>) -> X::Over<L> {
        x
    }

    #[inline(always)]
    fn call(&self, x: X::Over<L>, y: Y::Over<L>) -> <K::Output as Element>::Over<L> {
        self.0.call::<L>(x, y)
    }
}
