//! Transversions about the origin.

use ga_core::Field;

use crate::cga3::{TangentVector, Transversor, Vector3};

impl<T: Field> Transversor<T> {
    /// The transversion 1 − ½**v** n_o = e^{−**v** n_o/2} (2.4.4): an inversion in the unit
    /// sphere, a translation by ½**v**, and the inversion back. It keeps the origin, where it is
    /// the identity to first order, and sends the point −2**v**/**v**² to infinity.
    ///
    /// ```
    /// use ga_cga::{Point, Transversor, Vector3};
    ///
    /// let bend = Transversor::by(Vector3::new(2.0, 0.0, 0.0));
    /// // 1 inverts to 1, moves to 2, and inverts to ½.
    /// let image = Point::at(1.0, 0.0, 0.0).image_under(bend).unwrap();
    /// assert!(image.distance(Point::at(0.5, 0.0, 0.0)) < 1e-15);
    /// assert_eq!(Point::at(-1.0, 0.0, 0.0).image_under(bend), None);
    /// ```
    pub fn by(vector: Vector3<T>) -> Self {
        (TangentVector::from(vector.to_array()) * -T::from_ratio(1, 2)).exp()
    }

    /// The vector it is made of: twice the translation between the two inversions.
    pub fn vector(self) -> Vector3<T> {
        Vector3::new(self.e1no, self.e2no, self.e3no) * -T::from_integer(2)
    }

    /// The identity.
    pub fn identity() -> Self {
        Transversor::by(Vector3::default())
    }
}
