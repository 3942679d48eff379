//! How a camera turns to a target without rolling about its line of sight (algorithm 2.1).

use ga_cga::{Bivector3, Point, Rotor, Vector3};

/// The rotation that turns the z axis towards a target and keeps the y axis as upright as it can
/// be: in the upright plane through the line of sight.
///
/// `None` if the camera stands at its target, or looks straight up or down the y axis, where no
/// direction is more upright than another.
///
/// ```
/// use ga_cga::{Point, Vector3};
/// use ga_design::camera::without_roll;
///
/// let (camera, target) = (Point::at(0.0, 0.0, 0.0), Point::at(4.0, 3.0, 0.0));
/// let turn = without_roll(camera, target).unwrap();
/// let sight = turn.apply(Vector3::new(0.0, 0.0, 1.0));
/// assert!((sight - Vector3::new(0.8, 0.6, 0.0)).norm() < 1e-15);
/// let up = turn.apply(Vector3::new(0.0, 1.0, 0.0));
/// assert!((up - Vector3::new(-0.6, 0.8, 0.0)).norm() < 1e-15);
/// assert_eq!(without_roll(camera, Point::at(0.0, -5.0, 0.0)), None);
/// ```
#[must_use]
pub fn without_roll(camera: Point, target: Point) -> Option<Rotor> {
    let sight = target.position() - camera.position();
    let aim = directly(sight)?;
    // The plane that all directions across the line of sight lie in, and y as it is now.
    let across: Bivector3 = aim.apply(XY);
    let rolled: Vector3 = aim.apply(Y);
    let upright: Vector3 = Y.project(across);
    // Straight up or down, the projection is rounding error.
    if upright.norm() < 1e-9 {
        return None;
    }
    let unroll = Rotor::between_in(rolled, upright, across)?;
    Some(unroll * aim)
}

/// The rotation that turns the z axis in a direction by the shortest way (2.38), which rolls the
/// camera; for the direction opposite to z the half turn about y. `None` for a direction of length
/// zero.
#[must_use]
pub fn directly(direction: Vector3) -> Option<Rotor> {
    Rotor::between_in(Z, direction, Bivector3::new(0.0, 1.0, 0.0))
}

const Y: Vector3 = Vector3::new(0.0, 1.0, 0.0);
const Z: Vector3 = Vector3::new(0.0, 0.0, 1.0);
const XY: Bivector3 = Bivector3::new(1.0, 0.0, 0.0);
