//! Round elements: points, point pairs, circles and spheres, real and imaginary.
//!
//! A direct round is the outer product of points on it: two make a [`PointPair`] (2.47), three
//! a [`Circle`] (2.48), four a [`Sphere`] (2.49). It can also be built from what it looks like:
//! a centre, a squared radius and an attitude. A negative squared radius makes it imaginary: no
//! real point lies on it, but it has a centre, a plane and all the algebra of its real sisters.
//! A [`DualSphere`] is a centre and a squared radius in a single vector (2.52), and acts as an
//! inversion.
//!
//! Every round answers the same questions:
//!
//! ```
//! use ga_cga::{Bivector3, Circle, Plane, Point};
//!
//! let circle = Circle::about(Point::at(0.0, 0.0, 2.0), 9.0, Bivector3::new(1.0, 0.0, 0.0));
//! assert_eq!(circle.center(), Some(Point::at(0.0, 0.0, 2.0)));
//! assert_eq!(circle.radius_squared(), Some(9.0));
//! // The flat that it lies in, and the sphere of which it is a great circle.
//! assert_eq!(circle.carrier(), Plane::spanned(Point::at(5.0, 5.0, 2.0), Bivector3::new(1.0, 0.0, 0.0)));
//! assert_eq!(circle.surround().unwrap().radius_squared(), Some(9.0));
//! assert_eq!(circle.attitude().bivector(), Bivector3::new(1.0, 0.0, 0.0));
//! assert_eq!(circle.weight(), 1.0);
//!
//! let imaginary = Circle::about(Point::at(0.0, 0.0, 2.0), -9.0, Bivector3::new(1.0, 0.0, 0.0));
//! assert_eq!(imaginary.radius_squared(), Some(-9.0));
//! ```
//!
//! Points that do not determine a round are answered by what they do determine, or by a
//! [`Degenerate`] error:
//!
//! ```
//! use ga_cga::{Circle, CircleOrLine, Degenerate, Point};
//!
//! let [a, b, c] = [0.0, 1.0, 2.0].map(|x| Point::at(x, 0.0, 0.0));
//! assert!(matches!(Circle::through(a, b, c), Ok(CircleOrLine::Line(_))));
//! assert_eq!(Circle::through(a, b, a), Err(Degenerate::CoincidentPoints));
//! ```
//!
//! # Accuracy far from the origin
//! The coefficients of a round with its centre at distance d from the origin grow with d²; what
//! is stored is rounded relative to that. With ε the spacing of the number type (2.2e−16 for
//! `f64`), centres are known to within a few ε d, squared radii to within a few ε (d² + r²):
//! 10⁶ away a centre to 10⁻⁹ and a squared radius to 10⁻³. Directions, weights and distances
//! of flats are known to within a few ε relative to d.

mod circle;
mod degenerate;
mod dual_sphere;
mod point;
mod point_pair;
mod sphere;

use ga_core::Real;
use ga_core::convert::pick;

use crate::cga3::{
    Circle, DirectionBivector, DirectionTrivector, DirectionVector, DualSphere, Line, Plane, Point,
    PointPair, Pseudoscalar, Sphere,
};
use crate::classify::range::{length, within_range};

pub use circle::CircleOrLine;
pub use degenerate::Degenerate;
pub(crate) use degenerate::{coincide, collinear, underflows};
pub use point_pair::SplitPair;
pub use sphere::SphereOrPlane;

/// A direct round element of any grade above a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Round<T> {
    /// A round on a line: two points.
    PointPair(PointPair<T>),
    /// A round in a plane.
    Circle(Circle<T>),
    /// A round in space.
    Sphere(Sphere<T>),
}

/// The questions that all rounds answer by the same products.
macro_rules! round_queries {
    ($($Round:ident $Carrier:ident $Attitude:ident: $carrier:literal)*) => {$(
        impl<T: Real> $Round<T> {
            #[doc = concat!("The carrier ", $carrier)]
            pub fn carrier(self) -> $Carrier<T> {
                pick(self.wedge(DualSphere::infinity()))
            }

            /// The attitude −n_∞⌋(X∧n_∞): how the carrier lies, as large as the weight.
            pub fn attitude(self) -> $Attitude<T> {
                pick(-DualSphere::infinity().left_contract(self.carrier()))
            }

            /// The size of the attitude; zero for a flat element, which is no round.
            pub fn weight(self) -> T {
                length(self.attitude())
            }

            /// The squared radius, X X̃ over the same of the carrier: negative for an imaginary
            /// round, zero for a tangent. `None` for a flat element, which has none.
            pub fn radius_squared(self) -> Option<T> {
                let round = within_range(self)?;
                let weight_squared = round.carrier().norm_squared();
                let radius_squared = round.norm_squared() / weight_squared;
                (weight_squared.is_invertible() && radius_squared.is_finite())
                    .then_some(radius_squared)
            }

            /// The surround: the sphere with the same centre and squared radius, X over its
            /// carrier (2.61), normalised to weight 1. `None` for a flat element.
            pub fn surround(self) -> Option<DualSphere<T>> {
                let round = within_range(self)?;
                // The carrier's inverse is a multiple of it, and the weight is divided out.
                round.left_contract(round.carrier()).unit_weight()
            }

            /// The centre; `None` for a flat element, which has none.
            pub fn center(self) -> Option<Point<T>> {
                self.surround()?.center()
            }
        }
    )*};
}

round_queries! {
    PointPair Line DirectionVector: "κ∧n_∞ (2.50): the line through the two points."
    Circle Plane DirectionBivector: "K∧n_∞ (2.51): the plane of the circle."
    Sphere Pseudoscalar DirectionTrivector: "Σ∧n_∞: all of space, with the sphere's weight."
}
