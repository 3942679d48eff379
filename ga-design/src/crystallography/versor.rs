//! How a symmetry operation becomes versors of the conformal model: a motor, after one
//! reflection where the operation changes handedness.

use ga_cga::{DualPlane, Motor, Point, Rotor, Translator, Vector3};

use super::Placement;

/// A rigid motion with or without reflection, as the versors that carry it out.
///
/// By Cartan and Dieudonné an operation is at most three reflections in planes through the
/// origin and a translation. An even number of reflections is a rotor, the product of their
/// normals; of an odd number the reflection that acts first is kept as a dual plane. Rotor and
/// translator together are a motor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Isometry {
    /// The plane of the reflection that acts first, if the motion changes handedness.
    pub mirror: Option<DualPlane>,
    /// The proper motion that follows.
    pub motor: Motor,
}

impl Isometry {
    /// The image of a point.
    ///
    /// ```
    /// use ga_cga::Point;
    /// use ga_design::crystallography::{Isometry, Placement};
    ///
    /// // A glide: reflection in the plane z = 0, then a step along x.
    /// let glide = Placement { reflections: vec![[0.0, 0.0, 1.0]], translation: [2.0, 0.0, 0.0] };
    /// let image = Isometry::from(&glide).apply(Point::at(1.0, 1.0, 1.0));
    /// assert_eq!(image, Point::at(3.0, 1.0, -1.0));
    /// ```
    pub fn apply(&self, point: Point) -> Point {
        let reflected = match self.mirror {
            Some(plane) => plane.apply(point),
            None => point,
        };
        self.motor.apply(reflected)
    }
}

impl From<&Placement> for Isometry {
    fn from(placement: &Placement) -> Self {
        let normal = |n: &[f64; 3]| Vector3::from(*n);
        let (rotor, mirror) = match placement.reflections.as_slice() {
            [] => (Rotor::identity(), None),
            [only] => (Rotor::identity(), Some(normal(only))),
            [last, first] => (normal(last) * normal(first), None),
            [last, second, first, ..] => (normal(last) * normal(second), Some(normal(first))),
        };
        let translator = Translator::by(Vector3::from(placement.translation));
        Isometry {
            mirror: mirror.map(|normal| DualPlane::at_distance(normal, 0.0)),
            motor: Motor::rigid(rotor, translator),
        }
    }
}
