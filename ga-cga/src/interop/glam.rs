//! Points and rotations of `glam`, in both of its precisions.

use ::glam::{DQuat, DVec3, Quat, Vec3};

use super::convention::{quaternion_of, rotor_of};
use crate::cga3::{Point, Rotor, Vector3};

macro_rules! precision {
    ($number:ident $Vector:ident $Quaternion:ident) => {
        /// The point n_o + x + ½ x² n_∞ at position x.
        impl From<$Vector> for Point<$number> {
            fn from(position: $Vector) -> Self {
                Point::from(Vector3::from(position))
            }
        }

        /// The position of a point, which its weight of 1 leaves as it stands.
        impl From<Point<$number>> for $Vector {
            fn from(point: Point<$number>) -> Self {
                $Vector::from(point.position())
            }
        }

        /// The rotor w − x e23 + y e13 − z e12 of the quaternion w + x i + y j + z k.
        impl From<$Quaternion> for Rotor<$number> {
            fn from(quaternion: $Quaternion) -> Self {
                let [x, y, z, w] = quaternion.to_array();
                rotor_of([w, x, y, z])
            }
        }

        /// The quaternion s − e23 i + e13 j − e12 k of a rotor, without normalising it.
        impl From<Rotor<$number>> for $Quaternion {
            fn from(rotor: Rotor<$number>) -> Self {
                let [w, x, y, z] = quaternion_of(rotor);
                $Quaternion::from_xyzw(x, y, z, w)
            }
        }
    };
}

precision!(f32 Vec3 Quat);
precision!(f64 DVec3 DQuat);
