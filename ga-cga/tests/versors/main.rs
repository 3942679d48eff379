//! The transformations of section 2.4.4: that each does what plain vector geometry says, and
//! that all of them are covariant.

mod covariance;
mod degenerate;
mod drift;
mod exponentials;
#[cfg(feature = "nalgebra")]
mod independent;
mod interpolation;
mod matrices;
mod motions;
mod random;
mod reflections;
mod similarities;
