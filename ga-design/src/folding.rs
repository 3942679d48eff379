//! Folding by intersecting spheres (2.6): every length that a fold keeps is a sphere, and where a
//! corner may go is where spheres meet.
//!
//! Two spheres meet in a circle, on which a corner turns about a crease; three meet in a point
//! pair, the two places that are at the right distances from three corners. Which of the two a
//! corner takes is the choice of the fold mode. No angle is computed on the way.
//!
//! ```
//! use ga_design::folding::{FoldMode, Vertex};
//!
//! let sectors = [60.0_f64, 80.0, 120.0, 100.0].map(f64::to_radians);
//! let folded = Vertex::new(sectors)?.fold(0.5, FoldMode::Alike)?;
//! let [first, second, third, fourth] = folded.fold_angles();
//! // The folds of opposite creases are alike in size, because 60° + 120° make half a turn.
//! assert!((first.abs() - third.abs()).abs() < 1e-12);
//! assert!((second - 0.5).abs() < 1e-12 && (fourth - 0.5).abs() < 1e-12);
//! # Ok::<(), ga_design::folding::FoldError>(())
//! ```

mod meeting;
mod miura;
mod vertex;

pub use meeting::Meeting;
pub use miura::{FoldedSheet, Miura};
pub use vertex::{FoldMode, FoldedVertex, Vertex};

use thiserror::Error;

/// Why a pattern does not fold.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum FoldError {
    /// A sector angle is not between 0 and π, or the four do not add up to a whole turn.
    #[error(
        "the sector angles {sectors:?} make no flat vertex: each must be between 0 and π, and their sum 2π"
    )]
    Sectors {
        /// The angles in radians.
        sectors: [f64; 4],
    },
    /// A length is not positive or not finite.
    #[error("{what} is {value}: it must be positive and finite")]
    Length {
        /// Which length it is.
        what: &'static str,
        /// The length itself.
        value: f64,
    },
    /// An angle is not in the range in which the pattern folds.
    #[error("{what} is {value}: it must be {range}")]
    Angle {
        /// Which angle it is.
        what: &'static str,
        /// The angle in radians.
        value: f64,
        /// The range in words.
        range: &'static str,
    },
    /// A pattern of no panels, or of too many.
    #[error("{what} is {value}: it must be from {least} to {most}")]
    Count {
        /// Which number it is.
        what: &'static str,
        /// The number.
        value: usize,
        /// The smallest that makes a pattern.
        least: usize,
        /// The largest that is worth folding.
        most: usize,
    },
    /// Three spheres have a circle in common: the pattern is folded flat there, and the corner can
    /// turn freely.
    #[error("the spheres about {corner} share a whole circle: its place is open")]
    Open {
        /// Which corner has no place of its own.
        corner: &'static str,
    },
    /// Three spheres do not meet: the pattern cannot be folded so far.
    #[error("the spheres about {corner} do not meet: the pattern does not fold so far")]
    Apart {
        /// Which corner has no place.
        corner: &'static str,
    },
}
