//! Dual lines.

use ga_core::{Field, Real};

use crate::cga3::{DirectionVector, DualLine, Line, Point, Vector3};

impl<T: Field> DualLine<T> {
    /// The dual λ = **B** + **d** n_∞ (2.55) of the line through a point in this direction. With
    /// a direction of length 1 it generates the rotations about the line, anticlockwise seen
    /// against the direction; applied as a versor it is the half turn.
    ///
    /// ```
    /// use ga_cga::{DualLine, Point, Vector3};
    ///
    /// let axis = DualLine::along(Point::at(1.0, 0.0, 0.0), Vector3::new(0.0, 0.0, 1.0));
    /// let image: Point = axis.apply(Point::at(3.0, 0.0, 5.0));
    /// assert_eq!(image, Point::at(-1.0, 0.0, 5.0));
    /// ```
    pub fn along(point: Point<T>, direction: Vector3<T>) -> Self {
        Line::along(point, direction).dual()
    }
}

impl<T: Real> DualLine<T> {
    /// The attitude of the line that this is the dual of.
    pub fn attitude(self) -> DirectionVector<T> {
        self.undual().attitude()
    }

    /// The Euclidean vector along the line, as long as its weight.
    pub fn direction(self) -> Vector3<T> {
        self.undual().direction()
    }

    /// The length of the direction.
    pub fn weight(self) -> T {
        self.undual().weight()
    }

    /// The point of the line that is nearest to a given point; `None` where the direction is
    /// zero.
    pub fn nearest(self, point: Point<T>) -> Option<Point<T>> {
        self.undual().nearest(point)
    }
}
