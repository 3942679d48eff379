//! Euclidean bivectors and the directions of planes.

use ga_core::{Real, Scalar};

use crate::cga3::{Bivector3, DirectionBivector, Trivector3, Vector3};
use crate::classify::range::length;

impl<T: Scalar> Bivector3<T> {
    /// The normal of the plane, as long as the bivector is large: the Euclidean dual **B** I₃⁻¹.
    /// A rotation in the sense of the bivector is anticlockwise seen against it.
    pub fn normal(self) -> Vector3<T> {
        self.left_contract(Trivector3::new(-T::ONE))
    }
}

impl<T: Scalar> DirectionBivector<T> {
    /// The direction **B** n_∞ of a Euclidean bivector.
    ///
    /// ```
    /// use ga_cga::{Bivector3, DirectionBivector, Vector3};
    ///
    /// let level = DirectionBivector::of(Bivector3::new(1.0, 0.0, 0.0));
    /// assert_eq!(level.to_string(), "e12ni");
    /// assert_eq!(level.bivector().normal(), Vector3::new(0.0, 0.0, 1.0));
    /// ```
    pub fn of(bivector: Bivector3<T>) -> Self {
        DirectionBivector::from(bivector.to_array())
    }

    /// The Euclidean bivector **B** of the direction **B** n_∞.
    pub fn bivector(self) -> Bivector3<T> {
        Bivector3::from(self.to_array())
    }
}

impl<T: Real> DirectionBivector<T> {
    /// The area of the Euclidean bivector.
    pub fn weight(self) -> T {
        length(self)
    }
}
