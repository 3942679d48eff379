//! Dual spheres, real and imaginary, and the rounds that are cut out of them.

use ga_core::{Field, Real, Scalar};

use crate::cga3::{
    Bivector3, Circle, DirectionBivector, DirectionVector, DualSphere, Point, PointPair, Vector3,
};
use crate::classify::range::within_range;

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
}

impl<T: Scalar> DualSphere<T> {
    /// The point at infinity n_∞.
    pub fn infinity() -> Self {
        DualSphere {
            ni: T::ONE,
            ..DualSphere::default()
        }
    }

    /// The weight −σ·n_∞, 1 for a normalised sphere and 0 for a plane.
    pub fn weight(self) -> T {
        self.no
    }

    /// The pair in which the line through the centre along a vector meets the *imaginary*
    /// sister of the sphere, σ∧(σ⌋(**t** n_∞)) (2.59): imaginary for a real sphere, real for an
    /// imaginary one, the tangent vector for a point.
    ///
    /// ```
    /// use ga_cga::{DualSphere, Point, Vector3};
    ///
    /// let along = Vector3::new(0.0, 1.0, 0.0);
    /// let real = DualSphere::about(Point::at(1.0, 2.0, 3.0), 4.0);
    /// assert_eq!(real.pair_along(along).radius_squared(), Some(-4.0));
    /// ```
    pub fn pair_along(self, vector: Vector3<T>) -> PointPair<T> {
        self.wedge(self.left_contract(DirectionVector::along(vector)))
    }

    /// The circle in which the plane through the centre meets the *imaginary* sister of the
    /// sphere, σ∧(σ⌋(−**B** n_∞)) (2.59): imaginary for a real sphere, real for an imaginary
    /// one, the tangent bivector for a point.
    pub fn circle_in(self, plane: Bivector3<T>) -> Circle<T> {
        self.wedge(self.left_contract(-DirectionBivector::of(plane)))
    }
}

impl<T: Real> DualSphere<T> {
    /// The sphere about a position with a real radius.
    pub fn with_radius(center: Vector3<T>, radius: T) -> Self {
        DualSphere::about(Point::from(center), radius * radius)
    }

    /// The sphere over its weight; `None` for a plane, whose weight is zero, and where the
    /// quotient is out of range.
    pub fn unit_weight(self) -> Option<Self> {
        let weight = self.weight();
        let unit = self.map(|coefficient| coefficient / weight);
        let finite = unit.to_array().into_iter().all(Real::is_finite);
        (weight.is_invertible() && finite).then_some(unit)
    }

    /// The squared radius σ²/(σ·n_∞)², negative for an imaginary sphere and zero for a point;
    /// `None` for a plane, which has none.
    pub fn radius_squared(self) -> Option<T> {
        let sphere = within_range(self)?;
        let weight_squared = sphere.weight() * sphere.weight();
        let radius_squared = sphere.norm_squared() / weight_squared;
        (weight_squared.is_invertible() && radius_squared.is_finite()).then_some(radius_squared)
    }

    /// The centre; `None` for a plane, which has none.
    pub fn center(self) -> Option<Point<T>> {
        let weight = self.weight();
        let center = Point::at(self.e1 / weight, self.e2 / weight, self.e3 / weight);
        let finite = center.to_array().into_iter().all(Real::is_finite);
        (weight.is_invertible() && finite).then_some(center)
    }
}
