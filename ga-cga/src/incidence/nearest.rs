//! Nearest points of two elements.

use ga_core::Real;

use super::circle::Turn;
use super::figure::Figure;
use super::locus::{Locus, Unit, anywhere, aside};
use crate::cga3::{Point, Vector3};
use crate::classify::range::length;

/// The point of an element that is nearest to a given point; one of them where many are. `None`
/// where the element has no real and finite points: imaginary rounds, directions, zero.
///
/// ```
/// use ga_cga::{Circle, Point, Vector3, incidence::nearest};
///
/// let circle = Circle::with_normal(Point::at(0.0, 0.0, 0.0), 2.0, Vector3::new(0.0, 0.0, 1.0));
/// assert_eq!(nearest(circle.unwrap(), Point::at(3.0, 0.0, 5.0)), Some(Point::at(2.0, 0.0, 0.0)));
/// ```
pub fn nearest<F: Figure>(figure: F, point: Point<F::Number>) -> Option<Point<F::Number>> {
    let found = Locus::of(figure.direct())?.nearest(point.position());
    finite(found)
}

/// A point of each of two elements that are nearest to each other: twice the same where the
/// elements have a point in common; one choice where there are many. `None` where an element has
/// no real and finite points.
///
/// All cases are closed forms but those of a circle with a line or another circle. There the
/// whole circle (the smaller of two) is searched, and arcs are left out only where their length
/// bounds the distance from below; the least distance is found to within some roundings of the
/// size of the two, as they are stored (see [`round`](crate::round#accuracy-far-from-the-origin)
/// for what a small circle far from the origin keeps of its radius).
///
/// ```
/// use ga_cga::{Line, Point, Vector3, incidence::nearest_points};
///
/// let x_axis = Line::along(Point::at(0.0, 0.0, 0.0), Vector3::new(1.0, 0.0, 0.0));
/// let above = Line::along(Point::at(5.0, 7.0, 2.0), Vector3::new(0.0, 1.0, 0.0));
/// let both = nearest_points(x_axis, above);
/// assert_eq!(both, Some((Point::at(5.0, 0.0, 0.0), Point::at(5.0, 0.0, 2.0))));
/// ```
pub fn nearest_points<T, A, B>(a: A, b: B) -> Option<(Point<T>, Point<T>)>
where
    T: Real,
    A: Figure<Number = T>,
    B: Figure<Number = T>,
{
    let (p, q) = between(Locus::of(a.direct())?, Locus::of(b.direct())?);
    finite(p).zip(finite(q))
}

fn finite<T: Real>(position: Vector3<T>) -> Option<Point<T>> {
    let finite = position.to_array().into_iter().all(Real::is_finite);
    finite.then(|| Point::from(position))
}

/// Two positions, and the same in the other order.
type Both<T> = (Vector3<T>, Vector3<T>);

fn swapped<T>((p, q): Both<T>) -> Both<T> {
    (q, p)
}

fn between<T: Real>(a: Locus<T>, b: Locus<T>) -> Both<T> {
    use Locus::{Circle, Line, Pair, Plane, Point, Space, Sphere};
    match (a, b) {
        (Point(p), other) => (p, other.nearest(p)),
        (Pair(p, q), other) => nearer((p, other.nearest(p)), (q, other.nearest(q))),
        (other, Point(_) | Pair(..)) => swapped(between(b, other)),
        (Circle(..), Space) => {
            let p = a.nearest(Vector3::default());
            (p, p)
        }
        // The larger of two circles changes little along the smaller.
        (Circle(_, r, _), Circle(_, s, _)) if !r.all_le(s) => swapped(between(b, a)),
        (Circle(center, radius, plane), other) => {
            let turn = Turn::new(center, radius, plane);
            let p = match other {
                Plane(q, n) => turn.nearest_to_plane(q, n),
                Sphere(q, s) => turn.nearest_to_sphere(q, s),
                _ => turn.nearest_to(other),
            };
            (p, other.nearest(p))
        }
        (other, Circle(..)) => swapped(between(b, other)),
        (Sphere(c, r), Sphere(d, s)) => spheres((c, r), (d, s)),
        (Sphere(c, r), Line(_, t)) => sphere_and_flat((c, r), b, t),
        (Sphere(c, r), Plane(_, n)) => sphere_and_flat((c, r), b, aside(n)),
        (Sphere(c, r), Space) => sphere_and_flat((c, r), b, anywhere()),
        (other, Sphere(..)) => swapped(between(b, other)),
        (Line(p, t), Line(q, u)) => {
            let across = t.wedge(u);
            let square = length(across) * length(across);
            let d = q - p;
            if length(across).all_le(parallel()) {
                return (p, b.nearest(p));
            }
            // d = s t − r u + what is at right angles to both, and bivectors pick out s and r.
            let share = |side: Vector3<T>| d.wedge(side).scalar_product(across.reverse()) / square;
            (p + t * share(u), q + u * share(t))
        }
        (Line(p, t), Plane(q, n)) => {
            let rise = n.scalar_product(t);
            if rise.abs().all_le(parallel()) {
                return (p, b.nearest(p));
            }
            let x = p + t * (n.scalar_product(q - p) / rise);
            (x, x)
        }
        (Plane(p, n), Plane(q, m)) => {
            // Along the first plane, straight towards the second.
            let towards: Vector3<T> = m.reject(n);
            let rise = m.scalar_product(towards);
            if length(towards).all_le(parallel()) {
                return (p, b.nearest(p));
            }
            let x = p + towards * (m.scalar_product(q - p) / rise);
            (x, x)
        }
        (Plane(..), Line(..)) => swapped(between(b, a)),
        (Line(p, _) | Plane(p, _), Space) => (p, p),
        (Space, other) => {
            let p = other.nearest(Vector3::default());
            (p, p)
        }
    }
}

/// The sine up to which directions count as parallel.
fn parallel<T: Real>() -> T {
    T::EPSILON * T::from_integer(64)
}

fn nearer<T: Real>(one: Both<T>, two: Both<T>) -> Both<T> {
    let apart = |(p, q): Both<T>| length(p - q);
    if apart(one).all_le(apart(two)) {
        one
    } else {
        two
    }
}

/// A sphere and a flat that a vector of length 1 lies in.
fn sphere_and_flat<T: Real>(
    (c, r): (Vector3<T>, T),
    flat: Locus<T>,
    within: Vector3<T>,
) -> Both<T> {
    let foot = flat.nearest(c);
    let height = length(foot - c);
    if r.all_le(height) {
        return (Locus::Sphere(c, r).nearest(foot), foot);
    }
    let x = foot + within * ((r - height) * (r + height)).sqrt();
    (x, x)
}

fn spheres<T: Real>((c, r): (Vector3<T>, T), (d, s): (Vector3<T>, T)) -> Both<T> {
    let apart = length(d - c);
    let towards = (d - c).unit().unwrap_or_else(anywhere);
    if (r + s).all_le(apart) {
        return (c + towards * r, d - towards * s);
    }
    if (apart + s).all_le(r) {
        return (c + towards * r, d + towards * s);
    }
    if (apart + r).all_le(s) {
        return (c - towards * r, d - towards * s);
    }
    let along = (apart * apart + (r - s) * (r + s)) / (apart + apart);
    let out = ((r - along) * (r + along)).abs().sqrt();
    let x = c + towards * along + aside(towards) * out;
    (x, x)
}
