//! Dual planes.

use ga_core::{Real, Scalar};

use crate::cga3::{DirectionBivector, DualPlane, Point, Vector3};
use crate::classify::range::{length, within_range};

impl<T: Scalar> DualPlane<T> {
    /// The plane with this normal at a distance δ from the origin along it, **n** + δ n_∞
    /// (2.54); the normal has unit length.
    ///
    /// ```
    /// use ga_cga::{DualPlane, Point, Vector3};
    ///
    /// let plane = DualPlane::at_distance(Vector3::new(0.0, 0.0, 1.0), 2.0);
    /// let image: Point = plane.apply(Point::at(1.0, 2.0, 3.0));
    /// assert_eq!(image, Point::at(1.0, 2.0, 1.0));
    /// ```
    pub fn at_distance(normal: Vector3<T>, distance: T) -> Self {
        let [e1, e2, e3] = normal.to_array();
        DualPlane {
            e1,
            e2,
            e3,
            ni: distance,
        }
    }

    /// The normal, as long as the plane's weight.
    pub fn normal(self) -> Vector3<T> {
        Vector3::new(self.e1, self.e2, self.e3)
    }
}

impl<T: Real> DualPlane<T> {
    /// The plane through a point with this normal, which need not have unit length; `None` for
    /// a normal of length zero.
    pub fn through(point: Point<T>, normal: Vector3<T>) -> Option<Self> {
        let normal = within_range(normal)?.normalized()?;
        let distance = normal.scalar_product(point.position());
        Some(DualPlane::at_distance(normal, distance))
    }

    /// The distance δ of the plane from the origin along its normal, negative where the origin
    /// is on the side that the normal points to; `None` for a plane without a normal.
    ///
    /// ```
    /// use ga_cga::{DualPlane, Vector3};
    ///
    /// let plane = DualPlane::new(0.0, 0.0, -2.0, 6.0);
    /// assert_eq!(plane.distance_from_origin(), Some(3.0));
    /// assert_eq!(DualPlane::new(0.0, 0.0, 0.0, 1.0).distance_from_origin(), None);
    /// ```
    pub fn distance_from_origin(self) -> Option<T> {
        let weight = self.weight();
        let distance = self.ni / weight;
        (weight.is_invertible() && distance.is_finite()).then_some(distance)
    }

    /// The length of the normal.
    pub fn weight(self) -> T {
        length(self.normal())
    }

    /// The attitude of the plane that this is the dual of.
    pub fn attitude(self) -> DirectionBivector<T> {
        self.undual().attitude()
    }

    /// The point of the plane that is nearest to a given point; `None` for a plane without a
    /// normal.
    pub fn nearest(self, point: Point<T>) -> Option<Point<T>> {
        self.undual().nearest(point)
    }
}
