//! Lines.

use ga_core::{Field, Real};

use super::attitude;
use crate::cga3::{DirectionVector, DualSphere, Line, Point, Vector3};
use crate::classify::range::length;
use crate::round::{Degenerate, coincide};

impl<T: Field> Line<T> {
    /// The line through a point in this direction, p∧**t**∧n_∞, of weight |**t**|.
    ///
    /// ```
    /// use ga_cga::{Line, Point, Vector3};
    ///
    /// let line = Line::along(Point::at(0.0, 1.0, 0.0), Vector3::new(0.0, 0.0, 2.0));
    /// assert_eq!(line.weight(), 2.0);
    /// assert_eq!((Point::at(0.0, 1.0, 7.0) ^ line).norm(), 0.0);
    /// ```
    pub fn along(point: Point<T>, direction: Vector3<T>) -> Self {
        point.wedge(DirectionVector::along(direction))
    }
}

impl<T: Real> Line<T> {
    /// The line a∧b∧n_∞ from one point through another (2.50), of the weight of their distance.
    ///
    /// # Errors
    /// [`Degenerate::CoincidentPoints`] where the points are one, and
    /// [`Degenerate::NotFinite`].
    pub fn through(a: Point<T>, b: Point<T>) -> Result<Self, Degenerate> {
        let along = b.position() - a.position();
        let line = Line::along(a, along);
        if !length(line).is_finite() {
            return Err(Degenerate::NotFinite);
        }
        if coincide(a.position(), b.position()) {
            return Err(Degenerate::CoincidentPoints);
        }
        Ok(line)
    }

    /// The attitude −n_∞⌋Λ: the direction of the line, as long as its weight.
    pub fn attitude(self) -> DirectionVector<T> {
        attitude(DualSphere::infinity().left_contract(self))
    }

    /// The Euclidean vector along the line, as long as its weight.
    pub fn direction(self) -> Vector3<T> {
        self.attitude().vector()
    }

    /// The length of the direction.
    pub fn weight(self) -> T {
        length(self.direction())
    }
}
