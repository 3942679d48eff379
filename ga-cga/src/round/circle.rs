//! Circles.

use ga_core::convert::pick;
use ga_core::{Field, Real};

use super::Degenerate;
use super::degenerate::{coincide, collinear, underflows};
use crate::cga3::{Bivector3, Circle, DualSphere, Line, Point, Translator, Vector3};
use crate::classify::range::{larger, length};

/// What three points determine.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum CircleOrLine<T> {
    /// Their circle.
    Circle(Circle<T>),
    /// The line that they are on: a circle through infinity.
    Line(Line<T>),
}

impl<T> CircleOrLine<T> {
    /// The circle; `None` for a line.
    pub fn circle(self) -> Option<Circle<T>> {
        match self {
            CircleOrLine::Circle(circle) => Some(circle),
            CircleOrLine::Line(_) => None,
        }
    }

    /// The line; `None` for a circle.
    pub fn line(self) -> Option<Line<T>> {
        match self {
            CircleOrLine::Circle(_) => None,
            CircleOrLine::Line(line) => Some(line),
        }
    }
}

impl<T: Field> Circle<T> {
    /// The circle about a centre in the plane of a bivector and in its sense, with this squared
    /// radius; imaginary where that is negative (2.59). Its weight is |**B**|.
    pub fn about(center: Point<T>, radius_squared: T, plane: Bivector3<T>) -> Self {
        DualSphere::about(center, -radius_squared).circle_in(plane)
    }
}

impl<T: Real> Circle<T> {
    /// The circle about a centre with this radius around a normal of any length, anticlockwise
    /// seen against it; `None` for a normal of length zero. Its weight is 1.
    ///
    /// ```
    /// use ga_cga::{Circle, Point, Vector3};
    ///
    /// let circle = Circle::with_normal(Point::at(1.0, 0.0, 0.0), 2.0, Vector3::new(0.0, 5.0, 0.0));
    /// let circle = circle.unwrap();
    /// assert_eq!((Point::at(1.0, 0.0, 2.0) ^ circle).norm(), 0.0);
    /// assert_eq!(circle.normal(), Vector3::new(0.0, 1.0, 0.0));
    /// ```
    pub fn with_normal(center: Point<T>, radius: T, normal: Vector3<T>) -> Option<Self> {
        let size = length(normal);
        (size.is_invertible()).then(|| {
            let plane = (normal / size).orthogonal_plane();
            Circle::about(center, radius * radius, plane)
        })
    }

    /// The circle a∧b∧c through three points in this order (2.48), or the line where they are
    /// collinear. Collinear means: to within the rounding of the coordinates.
    ///
    /// The product is formed of the differences to the first point, so that circles far from
    /// the origin are as good as their points.
    ///
    /// ```
    /// use ga_cga::{Circle, CircleOrLine, Point};
    ///
    /// let [a, b] = [Point::at(1.0, 0.0, 0.0), Point::at(0.0, 1.0, 0.0)];
    /// let round = Circle::through(a, b, Point::at(-1.0, 0.0, 0.0)).unwrap();
    /// assert_eq!(round.circle().unwrap().radius_squared(), Some(1.0));
    /// let straight = Circle::through(a, b, Point::at(-1.0, 2.0, 0.0)).unwrap();
    /// assert!(straight.line().is_some());
    /// ```
    ///
    /// # Errors
    /// [`Degenerate::CoincidentPoints`] where two points are one, and
    /// [`Degenerate::NotFinite`].
    pub fn through(a: Point<T>, b: Point<T>, c: Point<T>) -> Result<CircleOrLine<T>, Degenerate> {
        let [x, y, z] = [a, b, c].map(Point::position);
        let [q, r] = [y, z].map(|position| Point::from(position - x));
        let local: Circle<T> = Point::at(T::ZERO, T::ZERO, T::ZERO).wedge(q).wedge(r);
        let circle: Circle<T> = Translator::by(x).apply(local);
        if !length(circle).is_finite() {
            return Err(Degenerate::NotFinite);
        }
        if coincide(x, y) || coincide(y, z) || coincide(z, x) {
            return Err(Degenerate::CoincidentPoints);
        }
        let [u, v] = [q, r].map(|point| length(point.position()));
        if underflows(u * v * larger(u, v)) {
            return Err(Degenerate::NotFinite);
        }
        if collinear(x, y, z) {
            let line: Line<T> = pick(local);
            return Ok(CircleOrLine::Line(Translator::by(x).apply(line)));
        }
        Ok(CircleOrLine::Circle(circle))
    }

    /// The normal of the circle's plane, as long as the weight.
    pub fn normal(self) -> Vector3<T> {
        self.attitude().bivector().normal()
    }
}
