//! Dual spheres, real and imaginary.

use ga_core::{Field, Real, Scalar};

use crate::cga3::{DualSphere, Point, Vector3};

impl<T: Field> DualSphere<T> {
    /// The sphere about a point with this squared radius, p − ½r² n_∞ (2.52); imaginary where
    /// the squared radius is negative (2.53).
    ///
    /// ```
    /// use ga_cga::{DualSphere, Point};
    ///
    /// let sphere = DualSphere::about(Point::at(1.0, 0.0, 0.0), 4.0);
    /// assert_eq!(sphere.radius_squared(), Some(4.0));
    /// assert_eq!(sphere | Point::at(3.0, 0.0, 0.0), ga_cga::Scalar::new(0.0));
    /// ```
    pub fn about(center: Point<T>, radius_squared: T) -> Self {
        let mut sphere = DualSphere::from(center);
        sphere.ni -= radius_squared * T::from_ratio(1, 2);
        sphere
    }

    /// The weight −σ·n_∞, 1 for a normalised sphere and 0 for a plane.
    pub fn weight(self) -> T {
        self.no
    }

    /// The squared radius σ²/(σ·n_∞)²; `None` for a plane, which has none.
    pub fn radius_squared(self) -> Option<T> {
        let weight_squared = self.weight() * self.weight();
        weight_squared
            .is_invertible()
            .then(|| self.norm_squared() / weight_squared)
    }

    /// The centre; `None` for a plane, which has none.
    pub fn center(self) -> Option<Point<T>> {
        let weight = self.weight();
        weight
            .is_invertible()
            .then(|| Point::at(self.e1 / weight, self.e2 / weight, self.e3 / weight))
    }
}

impl<T: Real> DualSphere<T> {
    /// The sphere about a position with a real radius.
    pub fn with_radius(center: Vector3<T>, radius: T) -> Self {
        DualSphere::about(Point::from(center), radius * radius)
    }
}

impl<T: Scalar> DualSphere<T> {
    /// The point at infinity n_∞.
    pub fn infinity() -> Self {
        DualSphere {
            ni: T::ONE,
            ..DualSphere::default()
        }
    }
}
