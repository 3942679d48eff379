//! Angles between elements.

use ga_core::Real;

use super::figure::Figure;
use super::frame::{Frame, main_grade};
use crate::cga3::{DualSphere, Multivector, Point};
use crate::classify::{Classification, Shape, classify_within};
use crate::direction::Direction;
use crate::flat::Flat;
use crate::round::Round;
use crate::tangent::Tangent;

/// The angle in radians at which two elements cross, or between their directions.
///
/// Between elements of one grade it is in [0, π] and depends on their orientations: lines by
/// their directions, planes by their normals, spheres by the angle between their radii to a common
/// point, circles by the angle of the spheres or planes that they are great in. Between elements
/// of different grade it is in [0, π/2]: a line with a plane, a circle with a sphere. In general
/// its cosine is the size of the projection of the smaller element onto the other: the product
/// of the cosines where they lie askew in more than one way, as two circles or planes need not
/// but two circles in space can.
///
/// Point pairs count as the lines through them, tangents as the flats that they span; with a
/// direction, circles count as their planes. `None` where there is no angle: with points and
/// spheres of directions, imaginary elements, and rounds that do not meet.
///
/// ```
/// use ga_cga::{DualPlane, DualSphere, Line, Point, Vector3, incidence::angle};
/// use core::f64::consts::{FRAC_PI_2, FRAC_PI_4};
///
/// let up = Vector3::new(0.0, 0.0, 1.0);
/// let ground = DualPlane::at_distance(up, 0.0);
/// let line = Line::along(Point::at(3.0, 2.0, 1.0), Vector3::new(1.0, 0.0, 1.0));
/// assert!((angle(line, ground).unwrap() - FRAC_PI_4).abs() < 1e-15);
/// assert!((angle(up, line).unwrap() - FRAC_PI_4).abs() < 1e-15);
/// let sphere = |x: f64, r: f64| DualSphere::with_radius(Vector3::new(x, 0.0, 0.0), r);
/// assert!((angle(sphere(0.0, 3.0), sphere(5.0, 4.0)).unwrap() - FRAC_PI_2).abs() < 1e-15);
/// assert_eq!(angle(sphere(0.0, 1.0), sphere(5.0, 1.0)), None);
/// ```
pub fn angle<A, B>(a: A, b: B) -> Option<A::Number>
where
    A: Figure,
    B: Figure<Number = A::Number>,
{
    let frame = Frame::of(a.direct(), b.direct()).ok()?;
    let shape = |x| match classify_within(x, frame.tolerance) {
        Classification::Direct(shape) => Some(shape),
        _ => None,
    };
    let (a, b) = (shape(frame.a)?, shape(frame.b)?);
    let is_direction = |shape| matches!(shape, Shape::Direction(_));
    let by_direction = is_direction(a) || is_direction(b);
    let a = crossing(a, by_direction)?;
    let b = crossing(b, by_direction)?;
    let (a, b) = if main_grade(a) <= main_grade(b) {
        (a, b)
    } else {
        (b, a)
    };
    between(a, b, frame.tolerance.relative)
}

/// The element that crosses in place of a shape, of size 1.
fn crossing<T: Real>(shape: Shape<T>, by_direction: bool) -> Option<Multivector<T>> {
    let infinity = Multivector::from(DualSphere::infinity());
    let element = Multivector::from(shape);
    let carrier = element.wedge(infinity);
    let crossing = match shape {
        Shape::Direction(Direction::Vector(_) | Direction::Bivector(_)) => {
            Multivector::from(Point::at(T::ZERO, T::ZERO, T::ZERO)).wedge(element)
        }
        Shape::Flat(Flat::Line(_) | Flat::Plane(_)) => element,
        Shape::RealRound(Round::PointPair(_)) => carrier,
        Shape::RealRound(Round::Circle(_)) if by_direction => carrier,
        Shape::RealRound(Round::Sphere(_)) if by_direction => return None,
        Shape::RealRound(_) => element,
        Shape::Tangent(Tangent::Vector(_) | Tangent::Bivector(_)) => carrier,
        _ => return None,
    };
    crossing.normalized()
}

/// The angle between two elements of size 1, the first not of higher grade.
fn between<T: Real>(a: Multivector<T>, b: Multivector<T>, tau: T) -> Option<T> {
    // Real elements hold one direction of negative square: X X̃ = −1, and X⁻¹ = −X̃.
    let inverse = -b.reverse();
    let shadow = a.left_contract(b).left_contract(inverse);
    let cosine_squared = -shadow.norm_squared();
    let sine_squared = -(a - shadow).norm_squared();
    // Where the two do not meet, the cosine is larger than one.
    if !(-tau).all_le(sine_squared) || !(-tau).all_le(cosine_squared) {
        return None;
    }
    let sine = sine_squared
        .select_le(T::ZERO, T::ZERO, sine_squared)
        .sqrt();
    let size = cosine_squared
        .select_le(T::ZERO, T::ZERO, cosine_squared)
        .sqrt();
    let opposite = main_grade(a) == main_grade(b)
        && T::ZERO.all_le(a.scalar_product(b.reverse()))
        && !size.all_le(T::ZERO);
    let cosine = if opposite { -size } else { size };
    let angle = sine.atan2(cosine);
    angle.is_finite().then_some(angle)
}
