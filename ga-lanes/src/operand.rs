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
    /// How many times the lanes can be filled.
    fn count(&self) -> usize;
    /// The element, where it is the same at every index.
    fn constant(&self) -> Option<X::Over<L>>
    where
        L: Lanes<X::Number>;
    /// The elements of the lanes at an index.
    ///
    /// # Safety
    /// The index is less than the count.
    unsafe fn read(&self, index: usize) -> X::Over<L>
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
        let arrays = L::arrays(numbers);
        let columns = X::BLADES.len();
        // With no column an element has no coefficient to be read.
        let stride = (stride / L::COUNT).min(arrays.len() / columns.max(1));
        Columns::<X, L> { arrays, stride }
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

/// The columns of a batch in arrays of lanes: as many columns as the type has coefficients, each
/// of `stride` arrays.
struct Columns<'a, X: Element<Number: Number>, L: Lanes<X::Number>> {
    arrays: &'a [L::Array],
    stride: usize,
}

impl<X: Element<Number: Number>, L: Lanes<X::Number>> Reader<X, L> for Columns<'_, X, L> {
    #[inline(always)]
    fn count(&self) -> usize {
        self.stride
    }

    #[inline(always)]
    fn constant(&self) -> Option<X::Over<L>> {
        None
    }

    #[inline(always)]
    unsafe fn read(&self, index: usize) -> X::Over<L> {
        X::Over::<L>::from_fn(|position| {
            if position >= X::BLADES.len() {
                return L::ZERO;
            }
            // SAFETY: there are `BLADES.len()` columns of `stride` arrays, the position was
            // compared, and the caller promises that the index is less than the stride. A
            // comparison for every number would cost as much as the arithmetic.
            L::load(unsafe { self.arrays.get_unchecked(position * self.stride + index) })
        })
    }
}

/// The same element in every lane.
struct Broadcast<X: Element, L: Lanes<X::Number>>(X::Over<L>)
where
    X::Number: Copy;

impl<X: Element, L: Lanes<X::Number>> Reader<X, L> for Broadcast<X, L> {
    #[inline(always)]
    fn count(&self) -> usize {
        usize::MAX
    }

    #[inline(always)]
    fn constant(&self) -> Option<X::Over<L>> {
        Some(self.0)
    }

    #[inline(always)]
    unsafe fn read(&self, _: usize) -> X::Over<L> {
        self.0
    }
}
