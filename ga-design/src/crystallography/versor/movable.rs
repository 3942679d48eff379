//! Which elements an isometry carries: all whose type mirrors and motors keep.

use ga_cga::{DualPlane, Motor};
use ga_core::ops::Apply;

use super::Isometry;

/// An element that a rigid motion or reflection maps to one of its own type: points, pairs,
/// circles, spheres, flats, their duals, directions, motors, general multivectors.
///
/// Types that name the origin, such as `Rotor` or `Vector3`, do not stay themselves when they are
/// moved; convert them first to what is meant (`Motor`, `DirectionVector`, `DualPlane`).
///
/// ```
/// use ga_cga::{Line, Point, DualSphere, Vector3};
/// use ga_design::crystallography::{Isometry, Movable};
///
/// let step = Isometry::translation(Vector3::new(0.0, 0.0, 3.0));
/// let points = Point::at(0.0, 0.0, 0.0) ^ Point::at(1.0, 0.0, 0.0);
/// let line: Line = (points ^ DualSphere::infinity()).narrow(1e-9).unwrap();
/// let moved = line.moved_by(&step);
/// assert!((moved ^ Point::at(7.0, 0.0, 3.0)).norm() < 1e-15);
/// ```
pub trait Movable: Copy {
    /// The image of the element under the isometry.
    #[must_use]
    fn moved_by(self, isometry: &Isometry) -> Self;
}

impl<X> Movable for X
where
    X: Copy,
    Motor: Apply<X, Output = X>,
    DualPlane: Apply<X, Output = X>,
{
    fn moved_by(self, isometry: &Isometry) -> Self {
        let reflected = match isometry.mirror {
            Some(plane) => plane.apply(self),
            None => self,
        };
        isometry.motor.apply(reflected)
    }
}
