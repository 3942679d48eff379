//! Tangent trivectors.

use ga_core::Field;
use ga_core::convert::pick;

use crate::cga3::{DualSphere, Point, Sphere, TangentTrivector, Trivector3};

impl<T: Field> TangentTrivector<T> {
    /// The tangent n_o∧**I** at the origin.
    ///
    /// ```
    /// use ga_cga::{TangentTrivector, Trivector3};
    ///
    /// let t = TangentTrivector::at_origin(Trivector3::new(2.0));
    /// assert_eq!(t.trivector(), Trivector3::new(2.0));
    /// ```
    pub fn at_origin(trivector: Trivector3<T>) -> Self {
        pick(Point::at(T::ZERO, T::ZERO, T::ZERO).wedge(trivector))
    }

    /// The Euclidean trivector of the tangent n_o∧**I**.
    pub fn trivector(self) -> Trivector3<T> {
        // n_∞ ⌋ (n_o∧I) = −I.
        -pick::<_, Trivector3<T>>(DualSphere::infinity().left_contract(self))
    }
}

impl<T: Field> Sphere<T> {
    /// The tangent trivector at a point: the limit of spheres about it.
    pub fn tangent(point: Point<T>) -> Self {
        DualSphere::from(point).undual()
    }
}
