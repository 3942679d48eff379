//! What two elements share, what they span, and what plunges into both.

use ga_core::Real;

use super::figure::Figure;
use super::frame::{Frame, basis_blade, largest_of, main_grade};
use crate::cga3::Multivector;
use crate::classify::{Classification, classify};

/// The meet: the largest element that lies in both.
///
/// Where the two span all of space it is (A*∧B*)⁻* (2.25), with that weight and orientation.
/// Where they span less, that formula gives zero, and the meet is formed within what they span:
/// two circles in one plane meet in a point pair, two lines in one plane in a flat point, a circle
/// and its plane in the circle. Its orientation and weight are then no one's but those of an
/// element that is in both itself, which is handed out as it is.
///
/// Degenerate meets are what they are: parallel planes share a direction, touching spheres a
/// tangent bivector, spheres without a common point an imaginary circle. What is shared can have
/// no points to be named by, and is then named by what it is the dual of, with
/// [`Classification::Dual`]: the sphere that cuts two circles at right angles which share no
/// point, the flat point in which all planes cross that cut two concentric spheres at right
/// angles. [`Classification::Number`] says that nothing at all is shared.
///
/// ```
/// use ga_cga::{Classification, DualSphere, Line, Point, Shape, Vector3, incidence::meet};
///
/// let [x, y] = [Vector3::new(1.0, 0.0, 0.0), Vector3::new(0.0, 1.0, 0.0)];
/// let here = Point::at(1.0, 2.0, 3.0);
/// let crossing = meet(Line::along(here, x), Line::along(here, y));
/// assert_eq!(crossing.flat_point().unwrap().location(), Some(here));
///
/// let [left, right] = [-1.0, 1.0].map(|x| DualSphere::with_radius(Vector3::new(x, 0.0, 0.0), 1.0));
/// let touching = meet(left, right);
/// assert!(matches!(touching, Classification::Direct(Shape::Tangent(_))));
/// ```
pub fn meet<A, B>(a: A, b: B) -> Classification<A::Number>
where
    A: Figure,
    B: Figure<Number = A::Number>,
{
    let [a, b] = [a.direct(), b.direct()];
    match Frame::of(a, b) {
        Ok(frame) => {
            let (shared, extended) = common(&frame, frame.a, frame.b);
            if extended {
                one_of_both(&frame, [a, b], shared)
            } else {
                frame.carry_back(shared)
            }
        }
        Err(none) => none,
    }
}

/// A meet or join with no weight of its own, carried back; or one of the two elements as it was
/// given where it has the grade of that one: what lies in an element, or holds it, and is of its
/// grade is the element itself.
fn one_of_both<T: Real>(
    frame: &Frame<T>,
    [a, b]: [Multivector<T>; 2],
    found: Multivector<T>,
) -> Classification<T> {
    let grade = main_grade(found);
    if grade == main_grade(frame.a) {
        classify(a)
    } else if grade == main_grade(frame.b) {
        classify(b)
    } else {
        frame.carry_back(found)
    }
}

/// What two elements of a frame share; and whether the second had to be extended because the
/// two do not span everything.
///
/// For any C outside of what A and B span, what A shares with B∧C it shares with B. The smallest
/// C for which (2.25) is not zero is therefore right, and of those the one with the largest
/// result.
fn common<T: Real>(
    frame: &Frame<T>,
    a: Multivector<T>,
    b: Multivector<T>,
) -> (Multivector<T>, bool) {
    let meet = |b: Multivector<T>| a.dual().wedge(b.dual()).undual();
    for grade in 0..=5_u32 {
        let masks = (0..32_usize).filter(|mask| mask.count_ones() == grade);
        let shared = largest_of(masks.map(|mask| meet(b.wedge(basis_blade(mask)))));
        if !frame.vanishes(shared) {
            return (shared, grade > 0);
        }
    }
    (meet(b), false)
}

/// The join: the smallest element that both lie in.
///
/// Where the two share nothing it is A∧B, with that weight and orientation: three points on two
/// elements span a circle, a line and a point beside it the plane. Where they share something it
/// is the smallest element that holds both; the weight and orientation are then no one's but
/// those of an element that holds the other, which is handed out as it is.
///
/// ```
/// use ga_cga::{Line, Point, Vector3, incidence::join};
///
/// let x_axis = Line::along(Point::at(0.0, 0.0, 0.0), Vector3::new(1.0, 0.0, 0.0));
/// let y_axis = Line::along(Point::at(0.0, 0.0, 0.0), Vector3::new(0.0, 1.0, 0.0));
/// let plane = join(x_axis, y_axis).plane().unwrap();
/// assert_eq!(plane.normal().e1, 0.0);
/// assert_eq!(plane.normal().e2, 0.0);
/// let pair = Point::at(1.0, 0.0, 0.0) ^ Point::at(-1.0, 0.0, 0.0);
/// let circle = join(pair, Point::at(0.0, 1.0, 0.0)).circle().unwrap();
/// assert_eq!(circle.radius_squared(), Some(1.0));
/// ```
pub fn join<A, B>(a: A, b: B) -> Classification<A::Number>
where
    A: Figure,
    B: Figure<Number = A::Number>,
{
    let [a, b] = [a.direct(), b.direct()];
    match Frame::of(a, b) {
        Ok(frame) => {
            let span = frame.a.wedge(frame.b);
            if !frame.vanishes(span) {
                return frame.carry_back(span);
            }
            // What holds both is at right angles to what is at right angles to both.
            let (outside, _) = common(&frame, frame.a.dual(), frame.b.dual());
            one_of_both(&frame, [a, b], outside.undual())
        }
        Err(none) => none,
    }
}

/// The plunge A*∧B*: the element that cuts both at right angles, dual to the meet (2.25).
///
/// ```
/// use ga_cga::{DualSphere, Vector3, incidence::plunge};
///
/// // The points that two spheres apart pinch between them.
/// let [a, b] = [-2.0, 2.0].map(|x| DualSphere::with_radius(Vector3::new(x, 0.0, 0.0), 1.0));
/// let pair = plunge(a, b).point_pair().unwrap();
/// assert_eq!(pair.radius_squared(), Some(3.0));
/// ```
pub fn plunge<A, B>(a: A, b: B) -> Classification<A::Number>
where
    A: Figure,
    B: Figure<Number = A::Number>,
{
    match Frame::of(a.direct(), b.direct()) {
        Ok(frame) => frame.carry_back(frame.a.dual().wedge(frame.b.dual())),
        Err(none) => none,
    }
}
