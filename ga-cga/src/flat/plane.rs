//! Planes.

use ga_core::{Field, Real};

use super::attitude;
use crate::cga3::{Bivector3, DirectionBivector, DualSphere, Plane, Point, Vector3};
use crate::classify::range::length;
use crate::round::{Degenerate, coincide, collinear, underflows};

impl<T: Field> Plane<T> {
    /// The plane through a point with the attitude of a bivector, p∧**B**∧n_∞.
    pub fn spanned(point: Point<T>, bivector: Bivector3<T>) -> Self {
        point.wedge(DirectionBivector::of(bivector))
    }

    /// The plane through a point with this normal, of weight |**n**|.
    ///
    /// ```
    /// use ga_cga::{DualPlane, Plane, Point, Vector3};
    ///
    /// let up = Vector3::new(0.0, 0.0, 1.0);
    /// let plane = Plane::with_normal(Point::at(5.0, 6.0, 2.0), up);
    /// assert_eq!(plane.normal(), up);
    /// assert_eq!(plane.dual(), DualPlane::at_distance(up, 2.0));
    /// ```
    pub fn with_normal(point: Point<T>, normal: Vector3<T>) -> Self {
        Plane::spanned(point, normal.orthogonal_plane())
    }
}

impl<T: Real> Plane<T> {
    /// The plane a∧b∧c∧n_∞ through three points (2.51), turning from a to b to c, of twice the
    /// weight of the area of their triangle.
    ///
    /// # Errors
    /// [`Degenerate::CoincidentPoints`], [`Degenerate::CollinearPoints`] where no single plane
    /// contains them, and [`Degenerate::NotFinite`].
    pub fn through(a: Point<T>, b: Point<T>, c: Point<T>) -> Result<Self, Degenerate> {
        let [x, y, z] = [a, b, c].map(Point::position);
        let plane = Plane::spanned(a, (y - x).wedge(z - x));
        if !length(plane).is_finite() {
            return Err(Degenerate::NotFinite);
        }
        if coincide(x, y) || coincide(y, z) || coincide(z, x) {
            return Err(Degenerate::CoincidentPoints);
        }
        if underflows(length(y - x) * length(z - x)) {
            return Err(Degenerate::NotFinite);
        }
        if collinear(x, y, z) {
            return Err(Degenerate::CollinearPoints);
        }
        Ok(plane)
    }

    /// The attitude −n_∞⌋Π: the direction of the plane, as large as its weight.
    pub fn attitude(self) -> DirectionBivector<T> {
        attitude(DualSphere::infinity().left_contract(self))
    }

    /// The normal, as long as the plane's weight.
    pub fn normal(self) -> Vector3<T> {
        self.attitude().bivector().normal()
    }

    /// The size of the attitude.
    pub fn weight(self) -> T {
        length(self.attitude())
    }
}
