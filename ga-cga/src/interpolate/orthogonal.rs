//! Circles that are linked and orthogonal, where many ways are equally short.

use ga_core::Real;

use crate::cga3::{Circle, Even, Point, PointPair};

impl<T: Real> Circle<T> {
    /// The versor that takes this circle to one that is linked with it and orthogonal to it, as a
    /// circle and its axis are: √C = (1 + C)/2 + B (1 − C)/2 for C = K₂/K₁ (5.16).
    ///
    /// There is a circle of such versors: B is any blade with B² = −1 that is made of one sphere
    /// through each of the circles. Here they are the spheres that pass nearest to a point, which
    /// so chooses the way.
    ///
    /// `None` if the circles are not both real, linked and orthogonal, or if the point lies on one
    /// of them and so has no sphere of its own.
    ///
    /// ```
    /// use ga_cga::interpolate::{Carry, ElementPath, NoPath, Way};
    /// use ga_cga::{Circle, DualSphere, Point};
    ///
    /// let [x, y, z] = [(1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)];
    /// let at = |(x, y, z)| Point::at(x, y, z);
    /// let circle: Circle = at(x) ^ at(y) ^ Point::at(-1.0, 0.0, 0.0);
    /// let axis: Circle = at(z) ^ Point::at(0.0, 0.0, 0.0) ^ DualSphere::infinity();
    /// assert_eq!(circle.versor_to(axis), Err(NoPath::ManyWays));
    /// let versor = circle.versor_to_orthogonal(axis, Point::at(1.0, 0.3, 0.2)).unwrap();
    /// let path = ElementPath::along(circle, versor, Way::Short)?.ending_at(axis)?;
    /// assert!((path.at(1.0) - axis).norm() < 1e-14);
    /// # Ok::<(), NoPath>(())
    /// ```
    pub fn versor_to_orthogonal(self, target: Self, nearest: Point<T>) -> Option<Even<T>> {
        let (from, to) = (self.normalized()?, target.normalized()?);
        // A circle is real if K² is positive, and K K̃ = −K².
        let real = |circle: Self| circle.norm_squared().all_le(T::ZERO);
        let ratio = to * from.inverse()?;
        let quadvector = ratio.grade(4);
        let tolerance = T::from_f64(1e-6);
        let square = (quadvector * quadvector).s;
        let rest = (ratio - quadvector).to_array();
        let small = rest.into_iter().all(|c| c.abs().all_le(tolerance));
        if !real(from) || !real(to) || !small || !(square - T::ONE).abs().all_le(tolerance) {
            return None;
        }
        // The vectors of the planes κ = K* are the spheres through the circle K.
        let [first, second]: [PointPair<T>; 2] = [from.dual(), to.dual()];
        let through = |pair: PointPair<T>| nearest.project(pair).normalized();
        let plane = (through(first)? ^ through(second)?).normalized()?;
        let half = T::from_ratio(1, 2);
        let one = Even::from(crate::cga3::Rotor::identity());
        let root = (one + ratio) * half + plane * ((one - ratio) * half);
        root.renormalized()
    }
}
