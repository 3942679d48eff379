//! Flat elements: flat points, lines and planes, which contain the point at infinity.
//!
//! A flat is a round that passes through infinity: where a circle is a∧b∧c, a line is
//! a∧b∧n_∞ (2.50). Direct flats ([`FlatPoint`], [`Line`], [`Plane`]) are products of the points
//! that they contain; dual flats ([`DualLine`](crate::DualLine),
//! [`DualPlane`](crate::DualPlane)) act: a dual plane reflects, a dual line generates the
//! rotations about it.
//!
//! Every direct flat knows its [`attitude`](Line::attitude), its [`weight`](Line::weight) (the
//! size of the attitude) and the point of it that is [`nearest`](Line::nearest) to any given
//! point.
//!
//! ```
//! use ga_cga::{Line, Plane, Point, Vector3};
//!
//! let line = Line::through(Point::at(0.0, 0.0, 1.0), Point::at(2.0, 0.0, 1.0)).unwrap();
//! assert_eq!(line.direction(), Vector3::new(2.0, 0.0, 0.0));
//! assert_eq!(line.nearest(Point::at(5.0, 3.0, 3.0)), Some(Point::at(5.0, 0.0, 1.0)));
//!
//! let [a, b, c] = [Point::at(1.0, 0.0, 0.0), Point::at(0.0, 1.0, 0.0), Point::at(0.0, 0.0, 0.0)];
//! let plane = Plane::through(a, b, c).unwrap();
//! assert_eq!(plane.normal(), Vector3::new(0.0, 0.0, 1.0));
//! assert!(Plane::through(a, a, b).is_err());
//! ```

mod dual_line;
mod dual_plane;
mod flat_point;
mod line;
mod plane;

use ga_core::Real;
use ga_core::convert::pick;

use crate::cga3::{DualSphere, FlatPoint, Line, Plane, Point, Pseudoscalar};
use crate::classify::range::within_range;

/// A direct flat element of any grade.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Flat<T> {
    /// A point and the point at infinity.
    Point(FlatPoint<T>),
    /// A line.
    Line(Line<T>),
    /// A plane.
    Plane(Plane<T>),
    /// All of space.
    Space(Pseudoscalar<T>),
}

/// The foot of the perpendicular from a point: the centre of the projection (p⌋X)⌋X of (2.29),
/// whose scale does not matter.
macro_rules! nearest_location {
    ($($Flat:ident)*) => {$(
        impl<T: Real> $Flat<T> {
            /// The point of this flat that is nearest to a given point, by projection (2.29);
            /// `None` where the flat has no place of its own because its attitude is zero.
            pub fn nearest(self, point: Point<T>) -> Option<Point<T>> {
                let flat = within_range(self)?;
                let from = within_range(DualSphere::from(point))?;
                let projected: DualSphere<T> = from.left_contract(flat).left_contract(flat);
                projected.center()
            }
        }
    )*};
}

nearest_location!(FlatPoint Line Plane);

/// The attitude from n_∞⌋X: its negative, in the type that stores all of it that is not zero.
fn attitude<Wide, Narrow>(contraction: Wide) -> Narrow
where
    Wide: ga_core::Element<Number: Real> + core::ops::Neg<Output = Wide>,
    Narrow: ga_core::Element<Number = Wide::Number>,
{
    pick(-contraction)
}
