//! Whether one element lies in another.

use ga_core::Real;

use super::figure::Figure;
use super::frame::{Frame, main_grade};
use crate::classify::Tolerance;
use crate::classify::range::{larger, length};

/// Whether the second element lies in the first: all its points do, and for tangents and
/// directions their attitude as well. To the default tolerance of [`Tolerance`].
///
/// ```
/// use ga_cga::{Circle, DirectionVector, DualPlane, Point, Vector3, incidence::contains};
///
/// let up = Vector3::new(0.0, 0.0, 1.0);
/// let plane = DualPlane::at_distance(up, 2.0);
/// let circle = Circle::with_normal(Point::at(3.0, 4.0, 2.0), 5.0, up).unwrap();
/// assert!(contains(plane, circle));
/// assert!(contains(circle, Point::at(8.0, 4.0, 2.0)));
/// assert!(!contains(circle, Point::at(3.0, 4.0, 2.0)), "the centre is not on the circle");
/// assert!(contains(plane, DirectionVector::along(Vector3::new(1.0, 1.0, 0.0))));
/// assert!(!contains(circle, plane));
/// ```
pub fn contains<A, B>(a: A, b: B) -> bool
where
    A: Figure,
    B: Figure<Number = A::Number>,
{
    contains_within(a, b, Tolerance::default().relative)
}

/// Whether the second element lies in the first, to within a fraction of the size of the two:
/// the larger of their radii and their distance, and 1 at least where neither is round.
///
/// ```
/// use ga_cga::{DualSphere, Point, Vector3, incidence::contains_within};
///
/// let sphere = DualSphere::with_radius(Vector3::new(0.0, 0.0, 0.0), 1.0);
/// let beside = Point::at(0.0, 1.000_1, 0.0);
/// assert!(contains_within(sphere, beside, 1e-3));
/// assert!(!contains_within(sphere, beside, 1e-6));
/// ```
pub fn contains_within<A, B>(a: A, b: B, tolerance: A::Number) -> bool
where
    A: Figure,
    B: Figure<Number = A::Number>,
{
    let Ok(frame) = Frame::of(a.direct(), b.direct()) else {
        return false;
    };
    // B lies in A where all its vectors are at right angles to those of A*: the product of the
    // two is then their outer product alone.
    let outside = frame.a.dual();
    let top = main_grade(frame.b) + main_grade(outside);
    let product = frame.b.geometric(outside);
    let excess = product - product.grade(top);
    top <= 5 && length(excess).all_le(larger(tolerance, frame.tolerance.relative))
}
