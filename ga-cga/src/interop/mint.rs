//! Points and rotations of `mint`, and through it of every library that speaks it.

use ::mint::{Point3, Quaternion};
use ga_core::{Field, Scalar};

use crate::cga3::{Point, Rotor};

/// The point n_o + x + ½ x² n_∞ at position x.
impl<T: Field> From<Point3<T>> for Point<T> {
    fn from(position: Point3<T>) -> Self {
        Point::at(position.x, position.y, position.z)
    }
}

/// The position of a point, which its weight of 1 leaves as it stands.
impl<T: Field> From<Point<T>> for Point3<T> {
    fn from(point: Point<T>) -> Self {
        Point3::from(point.position().to_array())
    }
}

/// The rotor w − x e23 + y e13 − z e12 of the quaternion w + x i + y j + z k.
impl<T: Scalar> From<Quaternion<T>> for Rotor<T> {
    fn from(quaternion: Quaternion<T>) -> Self {
        let [x, y, z] = quaternion.v.into();
        Rotor::from_quaternion([quaternion.s, x, y, z])
    }
}

/// The quaternion s − e23 i + e13 j − e12 k of a rotor.
impl<T: Scalar> From<Rotor<T>> for Quaternion<T> {
    fn from(rotor: Rotor<T>) -> Self {
        let [w, x, y, z] = rotor.to_quaternion();
        Quaternion::from([x, y, z, w])
    }
}
