//! Which matrices an algebra, or its even part, is isomorphic to, and which coefficient goes
//! where: the tables of [`ga_core::matrix`], found for every metric of orthogonal vectors of
//! square 1, −1 or 0 and of pairs of null vectors with inner product ±1.
//!
//! The even part of an algebra with a vector f, f² = ±1, is the algebra of the products of the
//! other vectors with f, whose inner products are those of the vectors times −f²; an odd element
//! is an even one times f.

mod blocks;
mod generators;
mod operands;
mod slots;

use ga_core::Metric;

pub use generators::Signed;
pub use operands::{Parity, Tables, Term};

use blocks::Blocks;
use operands::Frame;
use slots::Representation;

/// The geometric product of two operands of given parities through matrices; `None` where the
/// metric is beyond the method.
///
/// A coefficient is known by the bitmask of its blade in the basis of the metric.
pub fn tables(metric: &Metric, left: Parity, right: Parity) -> Option<Tables> {
    let blocks = Blocks::of(metric)?;
    let (blocks, frame) = match (left, right) {
        (Parity::Both, Parity::Both) => (blocks, Frame::Whole),
        _ => blocks.even()?,
    };
    let representation = Representation::of(&blocks)?;
    Some(operands::tables(&representation, frame, left, right))
}
