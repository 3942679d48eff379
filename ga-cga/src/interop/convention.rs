//! Which rotor a quaternion is.

use ga_core::Scalar;

use crate::cga3::Rotor;

/// The rotor of the quaternion w + x i + y j + z k.
pub(super) fn rotor_of<T: Scalar>([w, x, y, z]: [T; 4]) -> Rotor<T> {
    Rotor {
        s: w,
        e12: -z,
        e13: y,
        e23: -x,
    }
}

/// The quaternion w, x, y, z of a rotor.
pub(super) fn quaternion_of<T: Scalar>(rotor: Rotor<T>) -> [T; 4] {
    [rotor.s, -rotor.e23, rotor.e13, -rotor.e12]
}
