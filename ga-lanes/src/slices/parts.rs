//! Slices in two parts: whole blocks, and one block of what is left.

use ga_core::{Element, Scalar};

use crate::lanes::Lanes;
use crate::number::Number;

/// The most lanes that there are: 256 bits of `f32`.
pub const MOST_LANES: usize = 8;

/// A part of a slice.
#[derive(Clone, Copy)]
pub enum Part {
    /// As many blocks as are filled.
    Whole,
    /// What is left, filled up to a block.
    Rest,
}

impl Part {
    /// One after the other, by a loop: so the operation is compiled once for both.
    pub const BOTH: [Part; 2] = [Part::Whole, Part::Rest];
}

/// A slice that is written, in two parts.
pub struct Parts<'a, Z, L> {
    whole: &'a mut [Z],
    rest: &'a mut [Z],
    filled: [Z; MOST_LANES],
    lanes: core::marker::PhantomData<L>,
}

impl<'a, Z: Element<Number: Number>, L: Lanes<Z::Number>> Parts<'a, Z, L> {
    /// The parts of a slice.
    #[inline(always)]
    pub fn of(elements: &'a mut [Z]) -> Self {
        let (whole, rest) = elements.split_at_mut(elements.len() / L::COUNT * L::COUNT);
        let filled = filled_up(rest);
        let lanes = core::marker::PhantomData;
        Parts {
            whole,
            rest,
            filled,
            lanes,
        }
    }

    /// The blocks of a part; none of the rest where nothing is left.
    #[inline(always)]
    pub fn of_mut(&mut self, part: Part) -> &mut [Z] {
        match part {
            Part::Whole => self.whole,
            Part::Rest if self.rest.is_empty() => &mut [],
            Part::Rest => &mut self.filled[..L::COUNT],
        }
    }

    /// Writes the rest to the slice.
    #[inline(always)]
    pub fn finish(self) {
        for (place, value) in self.rest.iter_mut().zip(self.filled) {
            *place = value;
        }
    }
}

/// Elements, and as many others as fill the lanes.
#[inline(always)]
pub fn filled_up<X: Element>(rest: &[X]) -> [X; MOST_LANES] {
    let mut filled = [X::from_fn(|_| X::Number::ZERO); MOST_LANES];
    for (place, element) in filled.iter_mut().zip(rest) {
        *place = *element;
    }
    filled
}
