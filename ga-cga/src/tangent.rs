//! Tangents: attitudes at a point, rounds of radius zero (Table 2.6).
//!
//! Where two spheres touch, they share more than a point: the plane in which they touch. Their
//! meet is a tangent bivector, a circle of radius zero that still has an attitude. Tangents at
//! the origin, n_o∧**A**, have types of their own with few coefficients; a tangent elsewhere is
//! stored as the round that it is a limit of: a tangent vector as [`PointPair`], a tangent
//! bivector as [`Circle`], a tangent trivector as [`Sphere`]. They have all queries of rounds.
//!
//! ```
//! use ga_cga::{Point, PointPair, TangentVector, Vector3};
//!
//! let up = Vector3::new(0.0, 0.0, 1.0);
//! let here = Point::at(1.0, 2.0, 3.0);
//! let tangent = PointPair::tangent(here, up);
//! assert_eq!(tangent.radius_squared(), Some(0.0));
//! assert_eq!(tangent.center(), Some(here));
//! assert_eq!(tangent.attitude().vector(), up);
//! let origin = PointPair::tangent(Point::at(0.0, 0.0, 0.0), up);
//! assert_eq!(origin, PointPair::from(TangentVector::at_origin(up)));
//! ```

mod bivector;
mod trivector;
mod vector;

use crate::cga3::{Circle, Point, PointPair, Sphere};

/// A tangent of any grade, at any point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Tangent<T> {
    /// No attitude at all: a point, and how often it counts.
    Point {
        /// The point, normalised.
        point: Point<T>,
        /// The factor that it came with.
        weight: T,
    },
    /// A tangent vector, a point pair of radius zero.
    Vector(PointPair<T>),
    /// A tangent bivector, a circle of radius zero.
    Bivector(Circle<T>),
    /// A tangent trivector, a sphere of radius zero: the dual of a point.
    Trivector(Sphere<T>),
}
