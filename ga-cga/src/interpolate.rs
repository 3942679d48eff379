//! Interpolation (2.66, 2.67): the continuous motion from one versor or element to another.
//!
//! Every versor near the identity is e^{G} of a generator G, so e^{tG} has gone the part t of its
//! way. All paths here are made of that, and so go evenly: the step from 0 to t, taken again from
//! s, ends at s + t. They are evaluated at any t, with the start at 0 and the end at 1; other
//! values go on beyond.
//!
//! **From element to element**, A to B, the versor is R = √(B/A) (2.66), and the path R_t\[A\]
//! (2.67). For two unit vectors that is the rotation in their common plane (2.38), for lines the
//! screw about their common perpendicular, for spheres that cross the turn about their circle.
//! The weight goes along by equal factors, so that the path ends at the target itself.
//!
//! ```
//! use ga_cga::interpolate::{Carry, NoPath, Way};
//! use ga_cga::{Circle, Point};
//!
//! let ring = |z: f64, r: f64| -> Circle {
//!     Point::at(r, 0.0, z) ^ Point::at(0.0, r, z) ^ Point::at(-r, 0.0, z)
//! };
//! let path = ring(0.0, 1.0).path_to(ring(3.0, 2.0), Way::Short)?;
//! assert!((path.at(0.0) - ring(0.0, 1.0)).norm() < 1e-14);
//! assert!((path.at(1.0) - ring(3.0, 2.0)).norm() < 1e-12);
//! // Circles about one axis stay about it.
//! let middle = path.at(0.5).center().unwrap().position();
//! assert!(middle.e1.abs() < 1e-14 && middle.e2.abs() < 1e-14);
//! # Ok::<(), NoPath>(())
//! ```
//!
//! | from and to | what carries it ([`Carry`]) |
//! |---|---|
//! | vectors, bivectors, directions, tangents at the origin | a rotor (2.38) |
//! | points | a translator |
//! | flat points, lines, planes and their duals | a motor, √(B/A) |
//! | point pairs, circles, spheres and their duals | a general conformal rotor, √(B/A) |
//! | tangents elsewhere | a motor: moved and turned |
//! | elements of one coefficient | nothing but their weight |
//!
//! **Orientation counts.** From a sphere to one outside it no versor of their pencil leads,
//! unless one of the two is turned inside out. There is a choice: to the same sphere in whichever
//! orientation is nearer, [`path_to_either`](Carry::path_to_either), or as a similar figure,
//! [`similar_path_to`](Resemble::similar_path_to), which all rounds of a kind can go.
//!
//! ```
//! use ga_cga::interpolate::{Carry, NoPath, Resemble, Way};
//! use ga_cga::{DualSphere, Vector3};
//!
//! let small = DualSphere::with_radius(Vector3::new(0.0, 0.0, 0.0), 1.0);
//! let large = DualSphere::with_radius(Vector3::new(10.0, 0.0, 0.0), 2.0);
//! assert_eq!(small.path_to(large, Way::Short), Err(NoPath::Reversed));
//! let pencil = small.path_to_either(large, Way::Short)?;
//! assert!(pencil.at(0.5).radius_squared().unwrap() > 4.0);
//! let cone = small.similar_path_to(large, Way::Short)?;
//! assert!((cone.at(0.5).radius_squared().unwrap() - 2.0_f64).abs() < 1e-12);
//! # Ok::<(), NoPath>(())
//! ```
//!
//! **From versor to versor**, V₀ to V₁, the generator is log(V₁/V₀), of even and of odd versors
//! ([`Connect`]).
//!
//! **Which way** to turn is for the caller to say ([`Way`]), and where there is no path,
//! [`NoPath`] tells why. The kind of an element that is null by rounding, a tangent, is decided
//! as [`classify`](mod@crate::classify#tolerance) does, for a scene of the size of the two elements.
//!
//! # Accuracy
//! Paths of rounds are computed about the centre where they start, if that is farther from the
//! origin than the round is large: at a distance of d they lose no more than their coefficients
//! have lost, which know a squared radius to about 10⁻¹⁶ d². Pairs and circles of radius r are
//! refused where that has left no blade to within 10⁻⁶ r², from about 10⁵ r on in `f64`.

mod attitudes;
mod elements;
mod no_path;
mod null;
mod orthogonal;
mod ratio;
mod similar;
mod versors;
mod weight;

pub use elements::{Carry, ElementPath};
pub use no_path::NoPath;
pub use similar::Resemble;
pub use versors::{Connect, Continuous, VersorPath};

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
