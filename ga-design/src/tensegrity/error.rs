//! Decides what is said when a structure cannot be made or held in balance.

use crate::crystallography::RootsError;
use thiserror::Error;

/// Why there is no such structure.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum TensegrityError {
    /// Two struts cannot hold each other apart in space.
    #[error("{value} struts make no tensegrity: it takes at least 3")]
    FewStruts {
        /// The number of struts.
        value: usize,
    },
    /// A single stage is a prism.
    #[error("{value} stages make no tower: it takes at least 2")]
    FewStages {
        /// The number of stages.
        value: usize,
    },
    /// More of something than is computed with.
    #[error("{value} {what} are too many: at most {most}")]
    TooMany {
        /// What there are too many of.
        what: &'static str,
        /// How many there are.
        value: usize,
        /// How many there may be.
        most: usize,
    },
    /// A number is NaN, infinite, or out of its range.
    #[error("{what} is {value}: it must be {range}")]
    Number {
        /// Which number it is.
        what: &'static str,
        /// The number.
        value: f64,
        /// The range in words.
        range: &'static str,
    },
    /// No expanded octahedron has this ratio of cable to strut.
    #[error(
        "no expanded octahedron has cables of {value} times a strut's length: from {least:.7} (in balance) to {most:.7}"
    )]
    Ratio {
        /// The ratio.
        value: f64,
        /// The least one.
        least: f64,
        /// The largest one.
        most: f64,
    },
    /// A member joins nodes that coincide.
    #[error("the nodes {} and {} coincide: the member between them has no length", ends[0], ends[1])]
    NoLength {
        /// The nodes.
        ends: [usize; 2],
    },
    /// A member names a node that is not there.
    #[error("a member joins the nodes {} and {}, but there are only {nodes}", ends[0], ends[1])]
    NoSuchNode {
        /// The nodes that it names.
        ends: [usize; 2],
        /// The number of nodes.
        nodes: usize,
    },
    /// No values of what may move give a self-stress with struts in compression and cables in tension.
    #[error("no self-stress was found: {what}")]
    NoSelfStress {
        /// What was tried.
        what: &'static str,
    },
    /// There is no group of this order.
    #[error(transparent)]
    Roots(#[from] RootsError),
    /// A decomposition does not converge.
    #[error(
        "the rank of the equilibrium matrix cannot be decided: the structure is too nearly degenerate"
    )]
    Undecided,
}
