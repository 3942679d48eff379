//! Tangent bivectors.

use ga_core::Field;
use ga_core::convert::pick;

use crate::cga3::{Bivector3, Circle, DualSphere, Point, TangentBivector};

impl<T: Field> TangentBivector<T> {
    /// The tangent n_o∧**B** at the origin.
    ///
    /// ```
    /// use ga_cga::{Bivector3, TangentBivector};
    ///
    /// let t = TangentBivector::at_origin(Bivector3::new(1.0, 2.0, 3.0));
    /// assert_eq!(t.bivector(), Bivector3::new(1.0, 2.0, 3.0));
    /// ```
    pub fn at_origin(bivector: Bivector3<T>) -> Self {
        pick(Point::at(T::ZERO, T::ZERO, T::ZERO).wedge(bivector))
    }

    /// The Euclidean bivector **B** of the tangent n_o∧**B**.
    pub fn bivector(self) -> Bivector3<T> {
        // n_∞ ⌋ (n_o∧B) = −B.
        -pick::<_, Bivector3<T>>(DualSphere::infinity().left_contract(self))
    }
}

impl<T: Field> Circle<T> {
    /// The tangent bivector at a point: the limit of circles about it in this plane.
    pub fn tangent(point: Point<T>, plane: Bivector3<T>) -> Self {
        DualSphere::from(point).circle_in(plane)
    }
}
