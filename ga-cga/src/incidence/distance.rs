//! Distances between elements.

use ga_core::Real;

use super::figure::Figure;
use super::nearest::nearest_points;

/// The Euclidean distance between the nearest points of two elements, zero where they have one
/// in common; between points the root of −2 p·q (2.46). `None` where an element has no real and
/// finite points: imaginary rounds, directions, zero.
///
/// ```
/// use ga_cga::{Circle, DualSphere, Line, Point, Vector3, incidence::distance};
///
/// let p = Point::at(1.0, 2.0, 2.0);
/// assert_eq!(distance(Point::at(0.0, 0.0, 0.0), p), Some(3.0));
/// let sphere = DualSphere::with_radius(Vector3::new(4.0, 2.0, 2.0), 1.0);
/// assert_eq!(distance(p, sphere), Some(2.0));
/// let imaginary = DualSphere::about(p, -1.0);
/// assert_eq!(distance(p, imaginary), None);
/// ```
pub fn distance<A, B>(a: A, b: B) -> Option<A::Number>
where
    A: Figure,
    B: Figure<Number = A::Number>,
{
    let (p, q) = nearest_points(a, b)?;
    let distance = p.distance(q);
    distance.is_finite().then_some(distance)
}
