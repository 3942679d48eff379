//! Euclidean vectors and the directions of lines.

use ga_core::{Real, Scalar};

use crate::cga3::{Bivector3, DirectionVector, Trivector3, Vector3};
use crate::classify::range::length;

impl<T: Scalar> Vector3<T> {
    /// The plane bivector that this vector is the normal of, of the same size: **n** I₃.
    ///
    /// ```
    /// use ga_cga::{Bivector3, Vector3};
    ///
    /// let up = Vector3::new(0.0, 0.0, 2.0);
    /// assert_eq!(up.orthogonal_plane(), Bivector3::new(2.0, 0.0, 0.0));
    /// assert_eq!(up.orthogonal_plane().normal(), up);
    /// ```
    pub fn orthogonal_plane(self) -> Bivector3<T> {
        self.left_contract(Trivector3::new(T::ONE))
    }
}

impl<T: Scalar> DirectionVector<T> {
    /// The direction **t** n_∞ of a Euclidean vector.
    pub fn along(vector: Vector3<T>) -> Self {
        DirectionVector::from(vector.to_array())
    }

    /// The Euclidean vector **t** of the direction **t** n_∞, as long as its weight.
    pub fn vector(self) -> Vector3<T> {
        Vector3::from(self.to_array())
    }
}

impl<T: Real> DirectionVector<T> {
    /// The length of the Euclidean vector.
    pub fn weight(self) -> T {
        length(self)
    }
}
