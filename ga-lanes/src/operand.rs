//! Where the elements of an operation come from: a batch, or one for all.

use ga_core::Element;

use crate::batch::{Batch, View};
use crate::lanes::Lanes;
use crate::number::Number;

/// One element that meets every element of a batch: its coefficients are broadcast once.
///
/// It has the operations of a [`Batch`]; at least one operand has to be a batch, of whose length
/// the result is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct One<X>(pub X);

/// What an operation takes its elements from: a batch, or [`One`] element for all. Sealed.
pub trait Operand: Copy + Send + Sync + sealed::Operand {
    /// The type of the elements.
    type Element: Element<Number: Number>;
    /// How many elements there are; `None` where the one goes with any number.
    fn count(&self) -> Option<usize>;
    /// The elements for lanes.
    #[doc(hidden)]
    fn reader<L: Lanes<NumberOf<Self>>>(&self) -> impl Reader<Self::Element, L>;
}

/// The numbers of an operand.
pub type NumberOf<A> = <<A as Operand>::Element as Element>::Number;

/// Elements for lanes.
pub trait Reader<X: Element, L> {
    /// The elements of the lanes at an index.
    fn read(&self, index: usize) -> X::Over<L>
    where
        L: Lanes<X::Number>;
}

mod sealed {
    /// Keeps foreign types out of [`Operand`](super::Operand).
    pub trait Operand {}
}

impl<X: Element<Number: Number>> sealed::Operand for &Batch<X> {}
impl<X> sealed::Operand for One<X> {}

impl<X: Element<Number: Number> + Send + Sync> Operand for &Batch<X> {
    type Element = X;

    fn count(&self) -> Option<usize> {
        Some(self.len())
    }

    #[inline(always)]
    fn reader<L: Lanes<X::Number>>(&self) -> impl Reader<X, L> {
        let View { numbers, stride } = self.view();
        Columns::<X::Number, L> {
            arrays: L::arrays(numbers),
            stride: stride / L::COUNT,
        }
    }
}

impl<X: Element<Number: Number> + Send + Sync> Operand for One<X> {
    type Element = X;

    fn count(&self) -> Option<usize> {
        None
    }

    #[inline(always)]
    fn reader<L: Lanes<X::Number>>(&self) -> impl Reader<X, L> {
        Broadcast::<X, L>(X::Over::<L>::from_fn(|position| {
            L::splat(self.0.at(position))
        }))
    }
}

/// The columns of a batch in arrays of lanes, `stride` of them a column.
struct Columns<'a, F: Number, L: Lanes<F>> {
    arrays: &'a [L::Array],
    stride: usize,
}

impl<X: Element, L: Lanes<X::Number>> Reader<X, L> for Columns<'_, X::Number, L>
where
    X::Number: Number,
{
    #[inline(always)]
    fn read(&self, index: usize) -> X::Over<L> {
        X::Over::<L>::from_fn(|position| L::load(&self.arrays[position * self.stride + index]))
    }
}

/// The same element in every lane.
struct Broadcast<X: Element, L: Lanes<X::Number>>(X::Over<L>)
where
    X::Number: Copy;

impl<X: Element, L: Lanes<X::Number>> Reader<X, L> for Broadcast<X, L> {
    #[inline(always)]
    fn read(&self, _: usize) -> X::Over<L> {
        self.0
    }
}
