//! Tangent vectors.

use ga_core::Field;
use ga_core::convert::pick;

use crate::cga3::{DualSphere, Point, PointPair, TangentVector, Vector3};

impl<T: Field> TangentVector<T> {
    /// The tangent n_o∧**t** at the origin.
    ///
    /// ```
    /// use ga_cga::{TangentVector, Vector3};
    ///
    /// let t = TangentVector::at_origin(Vector3::new(1.0, 2.0, 3.0));
    /// assert_eq!(t.vector(), Vector3::new(1.0, 2.0, 3.0));
    /// ```
    pub fn at_origin(vector: Vector3<T>) -> Self {
        pick(Point::at(T::ZERO, T::ZERO, T::ZERO).wedge(vector))
    }

    /// The Euclidean vector **t** of the tangent n_o∧**t**.
    pub fn vector(self) -> Vector3<T> {
        // n_∞ ⌋ (n_o∧t) = −t.
        -pick::<_, Vector3<T>>(DualSphere::infinity().left_contract(self))
    }
}

impl<T: Field> PointPair<T> {
    /// The tangent vector at a point: the limit of point pairs about it in this direction.
    pub fn tangent(point: Point<T>, vector: Vector3<T>) -> Self {
        DualSphere::from(point).pair_along(vector)
    }
}
