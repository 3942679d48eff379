//! Orthogonal projection and rejection of any element on any other.

use ga_core::{Field, Real};

use super::figure::Figure;
use super::frame::Frame;
use crate::cga3::Multivector;
use crate::classify::Classification;

/// The projection (A⌋B)B⁻¹ of the first element onto the second (2.29): the part of B that cuts
/// A at right angles, of the grade of A. `None` where B squares to zero and nothing can be
/// projected onto it: tangents, points and directions.
///
/// A line on a plane casts a line, a circle on a plane the circle that the sphere standing on it
/// cuts, a circle on a sphere a circle of it. A point casts a dual sphere about the foot of its
/// perpendicular; [`nearest`](super::nearest) gives the foot itself.
///
/// ```
/// use ga_cga::{DualPlane, Line, Point, Vector3, incidence::project};
///
/// let ground = DualPlane::at_distance(Vector3::new(0.0, 0.0, 1.0), 0.0);
/// let slope = Line::along(Point::at(0.0, 1.0, 5.0), Vector3::new(1.0, 0.0, -1.0));
/// let shadow = project(slope, ground).and_then(|shadow| shadow.line()).unwrap();
/// assert_eq!(shadow.direction(), Vector3::new(1.0, 0.0, 0.0));
/// assert_eq!(shadow.nearest(Point::at(0.0, 0.0, 0.0)), Some(Point::at(0.0, 1.0, 0.0)));
/// ```
pub fn project<A, B>(a: A, b: B) -> Option<Classification<A::Number>>
where
    A: Figure,
    B: Figure<Number = A::Number>,
{
    onto(a, b, |a, b, inverse| {
        a.left_contract(b).left_contract(inverse)
    })
}

/// The rejection (A∧B)B⁻¹ of the first element from the second (2.30): what of A is at right
/// angles to B, of the grade of A. `None` where B squares to zero.
///
/// ```
/// use ga_cga::{Classification, DualPlane, Line, Point, Vector3, incidence::reject};
///
/// let ground = DualPlane::at_distance(Vector3::new(0.0, 0.0, 1.0), 0.0);
/// let on_it = Line::along(Point::at(0.0, 1.0, 0.0), Vector3::new(1.0, 0.0, 0.0));
/// assert_eq!(reject(on_it, ground), Some(Classification::Zero));
/// ```
pub fn reject<A, B>(a: A, b: B) -> Option<Classification<A::Number>>
where
    A: Figure,
    B: Figure<Number = A::Number>,
{
    onto(a, b, |a, b, inverse| a.wedge(b).right_contract(inverse))
}

fn onto<A, B>(
    a: A,
    b: B,
    part: impl Fn(
        Multivector<A::Number>,
        Multivector<A::Number>,
        Multivector<A::Number>,
    ) -> Multivector<A::Number>,
) -> Option<Classification<A::Number>>
where
    A: Figure,
    B: Figure<Number = A::Number>,
{
    let frame = match Frame::of(a.direct(), b.direct()) {
        Ok(frame) => frame,
        Err(none) => return Some(none),
    };
    let square = frame.b.norm_squared();
    if square.abs().all_le(frame.tolerance.relative) || !square.is_invertible() {
        return None;
    }
    let inverse = frame.b.reverse() / square;
    Some(frame.carry_back_first(part(frame.a, frame.b, inverse)))
}
