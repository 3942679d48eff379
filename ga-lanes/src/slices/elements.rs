//! Where the elements of an operation on slices come from: a slice, or one for all.

use ga_core::Element;

use super::parts::{MOST_LANES, Part, filled_up};
use super::transpose::gathered;
use crate::lanes::Lanes;
use crate::number::Number;
use crate::operand::One;

/// What an operation on slices takes its elements from: a slice, or [`One`] element for all.
/// Sealed.
pub trait Elements: Copy + sealed::Elements {
    /// The type of the elements.
    type Element: Element<Number: Number>;
    /// How many elements there are; `None` where the one goes with any number.
    fn count(&self) -> Option<usize>;
    /// The elements for lanes.
    #[doc(hidden)]
    fn blocks<L: Lanes<<Self::Element as Element>::Number>>(&self)
    -> impl Blocks<Self::Element, L>;
}

/// The numbers of elements.
pub type NumberOf<A> = <<A as Elements>::Element as Element>::Number;

/// Elements, as many at a time as there are lanes.
pub trait Blocks<X: Element, L> {
    /// The elements of a block; in the rest, lanes beyond the last element hold anything.
    fn read(&self, part: Part, index: usize) -> X::Over<L>
    where
        L: Lanes<X::Number>;
}

mod sealed {
    /// Keeps foreign types out of [`Elements`](super::Elements).
    pub trait Elements {}
}

impl<X: Element<Number: Number>> sealed::Elements for &[X] {}
impl<X: Element<Number: Number>> sealed::Elements for &Vec<X> {}
impl<X: Element<Number: Number>, const N: usize> sealed::Elements for &[X; N] {}
impl<X: Element<Number: Number>> sealed::Elements for One<X> {}

impl<X: Element<Number: Number>> Elements for &[X] {
    type Element = X;

    fn count(&self) -> Option<usize> {
        Some(self.len())
    }

    #[inline(always)]
    fn blocks<L: Lanes<X::Number>>(&self) -> impl Blocks<X, L> {
        Structs::new::<L>(self)
    }
}

impl<X: Element<Number: Number>> Elements for &Vec<X> {
    type Element = X;

    fn count(&self) -> Option<usize> {
        Some(self.len())
    }

    #[inline(always)]
    fn blocks<L: Lanes<X::Number>>(&self) -> impl Blocks<X, L> {
        Structs::new::<L>(self)
    }
}

impl<X: Element<Number: Number>, const N: usize> Elements for &[X; N] {
    type Element = X;

    fn count(&self) -> Option<usize> {
        Some(N)
    }

    #[inline(always)]
    fn blocks<L: Lanes<X::Number>>(&self) -> impl Blocks<X, L> {
        Structs::new::<L>(self.as_slice())
    }
}

impl<X: Element<Number: Number>> Elements for One<X> {
    type Element = X;

    fn count(&self) -> Option<usize> {
        None
    }

    #[inline(always)]
    fn blocks<L: Lanes<X::Number>>(&self) -> impl Blocks<X, L> {
        Same::<X, L>(X::Over::<L>::from_fn(|position| {
            L::splat(self.0.at(position))
        }))
    }
}

/// Elements in a slice, in whole blocks and what is left.
struct Structs<'a, X> {
    whole: &'a [X],
    rest: [X; MOST_LANES],
}

impl<'a, X: Element<Number: Number>> Structs<'a, X> {
    #[inline(always)]
    fn new<L: Lanes<X::Number>>(elements: &'a [X]) -> Self {
        let (whole, rest) = elements.split_at(elements.len() / L::COUNT * L::COUNT);
        let rest = filled_up(rest);
        Structs { whole, rest }
    }
}

impl<X: Element<Number: Number>, L: Lanes<X::Number>> Blocks<X, L> for Structs<'_, X> {
    #[inline(always)]
    fn read(&self, part: Part, index: usize) -> X::Over<L> {
        let elements = match part {
            Part::Whole => self.whole,
            Part::Rest => &self.rest,
        };
        let start = index * L::COUNT;
        match elements.get(start..start + L::COUNT) {
            Some(block) => gathered::<X, L>(block),
            None => X::Over::<L>::from_fn(|_| L::ZERO),
        }
    }
}

/// The same element in every lane.
struct Same<X: Element, L: Lanes<X::Number>>(X::Over<L>)
where
    X::Number: Copy;

impl<X: Element, L: Lanes<X::Number>> Blocks<X, L> for Same<X, L> {
    #[inline(always)]
    fn read(&self, _: Part, _: usize) -> X::Over<L> {
        self.0
    }
}
