//! The transformations of section 2.4.4: that each does what plain vector geometry says, and
//! that all of them are covariant.

mod covariance;
mod degenerate;
mod drift;
#[cfg(feature = "nalgebra")]
mod independent;
mod matrices;
mod motions;
mod random;
mod reflections;
mod similarities;
