//! The direction of space, which spheres have as their attitude.

use ga_core::{Real, Scalar};

use crate::cga3::{DirectionTrivector, Trivector3};

impl<T: Scalar> DirectionTrivector<T> {
    /// The direction **I**₃ n_∞ of a Euclidean trivector.
    ///
    /// ```
    /// use ga_cga::{DirectionTrivector, Trivector3};
    ///
    /// let space = DirectionTrivector::of(Trivector3::new(-2.0));
    /// assert_eq!(space.trivector(), Trivector3::new(-2.0));
    /// assert_eq!(space.weight(), 2.0);
    /// ```
    pub fn of(trivector: Trivector3<T>) -> Self {
        DirectionTrivector::from(trivector.to_array())
    }

    /// The Euclidean trivector of the direction.
    pub fn trivector(self) -> Trivector3<T> {
        Trivector3::from(self.to_array())
    }
}

impl<T: Real> DirectionTrivector<T> {
    /// The volume of the Euclidean trivector, without its sign.
    pub fn weight(self) -> T {
        let [volume] = self.to_array();
        volume.abs()
    }
}
