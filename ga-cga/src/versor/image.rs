//! Where a versor takes a point, as a point again.

use ga_core::Real;
use ga_core::ops::Apply;

use crate::cga3::{DualSphere, Point, Vector3};

impl<T: Real> Point<T> {
    /// The image of the point under any versor, with weight 1 again (2.28).
    ///
    /// `None` where the image is the point at infinity, as that of a sphere's centre under
    /// inversion in the sphere, and where the versor has no inverse, or is so light or heavy that
    /// the square of its size is out of range. An image is taken for that
    /// point too where rounding has drowned its weight, about 10⁸ away in double precision.
    ///
    /// ```
    /// use ga_cga::{DualSphere, Point, Vector3};
    ///
    /// let sphere = DualSphere::with_radius(Vector3::new(0.0, 0.0, 0.0), 2.0);
    /// let image = Point::at(1.0, 0.0, 0.0).image_under(sphere);
    /// assert_eq!(image, Some(Point::at(4.0, 0.0, 0.0)));
    /// assert_eq!(Point::at(0.0, 0.0, 0.0).image_under(sphere), None);
    /// assert_eq!(image.and_then(|p| p.image_under(DualSphere::<f64>::infinity())), None);
    /// ```
    pub fn image_under<V>(self, versor: V) -> Option<Self>
    where
        V: Apply<Point<T>>,
        DualSphere<T>: From<V::Output>,
    {
        let image = DualSphere::from(versor.apply(self));
        let direction = Vector3::new(image.e1, image.e2, image.e3);
        let position = if image.ni.abs().all_le(image.no.abs()) {
            direction / image.no
        } else {
            // Outside the unit sphere the null vector w (n_o + x + ½ x² n_∞) has a small weight
            // w, exact only against the other coefficients: x is w x over its inverse length.
            let square = direction.norm_squared();
            let double = image.ni * T::from_integer(2);
            let off = (square - image.no * double).abs();
            if !off.all_le(square * T::from_ratio(1, 2)) {
                return None;
            }
            direction * (double / square)
        };
        let point = Point::from(position);
        point.ni.is_finite().then_some(point)
    }
}
