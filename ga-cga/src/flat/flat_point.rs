//! Flat points: a point together with the point at infinity.

use ga_core::{Field, Real};

use crate::cga3::{DualSphere, FlatPoint, Point};

impl<T: Field> FlatPoint<T> {
    /// The flat point p∧n_∞ at a point.
    ///
    /// ```
    /// use ga_cga::{FlatPoint, Point};
    ///
    /// let p = Point::at(1.0, 2.0, 3.0);
    /// let flat = FlatPoint::at(p);
    /// assert_eq!(flat.to_string(), "e1ni + 2 e2ni + 3 e3ni + noni");
    /// assert_eq!(flat.location(), Some(p));
    /// ```
    pub fn at(point: Point<T>) -> Self {
        ga_core::convert::pick(point.wedge(DualSphere::infinity()))
    }

    /// The weight: how often the flat point counts, with its sign; zero for a direction vector.
    pub fn weight(self) -> T {
        // n_o ⌋ (n_∞ ⌋ (p∧n_∞)) takes off both factors.
        let attitude = DualSphere::infinity().left_contract(self);
        Point::at(T::ZERO, T::ZERO, T::ZERO).scalar_product(attitude)
    }
}

impl<T: Real> FlatPoint<T> {
    /// The point; `None` for a direction vector, whose point is at infinity.
    pub fn location(self) -> Option<Point<T>> {
        // n_o ⌋ (p∧n_∞) = p up to its n_∞, and a sphere about p for all that.
        let origin = Point::at(T::ZERO, T::ZERO, T::ZERO);
        origin.left_contract(self).center()
    }
}
