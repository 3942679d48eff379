//! Interpolation (2.66, 2.67): the continuous motion from one versor or element to another.
//!
//! Every versor near the identity is e^{G} of a generator G, so e^{tG} has gone the part t of its
//! way. From versor V₀ to V₁ the generator is log(V₁/V₀); from element A to B it is that of the
//! versor R = √(B/A), which takes A to B (2.66). Both give paths that are evaluated at any t, with
//! the start at 0 and the end at 1; other values go on beyond.
//!
//! ```
//! use ga_cga::interpolate::{Carry, Way};
//! use ga_cga::{DualSphere, Vector3};
//!
//! let small = DualSphere::with_radius(Vector3::new(0.0, 0.0, 0.0), 1.0);
//! let large = DualSphere::with_radius(Vector3::new(10.0, 0.0, 0.0), 2.0);
//! // Spheres outside one another are oriented alike if one of them is turned inside out.
//! let path = small.path_to(-large, Way::Short).unwrap();
//! let between: DualSphere = path.at(0.5);
//! assert!(between.radius_squared().unwrap() > 4.0);
//! let end = path.at(1.0);
//! assert!((end.radius_squared().unwrap() - 4.0).abs() < 1e-12);
//! ```

mod elements;
mod orthogonal;
mod versors;

pub use elements::{Carry, ElementPath};
pub use versors::{Continuous, VersorPath};

/// Which way to go: V and −V do the same, but their logarithms are two ways to it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Way {
    /// The way on which a turn is at most half a turn.
    #[default]
    Short,
    /// The way that turns in the other sense, by what is left to a whole turn (2.70). There is
    /// none for what does not turn, as translations and scalings.
    Long,
}
