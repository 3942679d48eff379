//! Points and motions of `nalgebra`.

use ::nalgebra::{Isometry3, Point3, Quaternion, Translation3, Unit, UnitQuaternion};
use ga_core::{Field, Scalar};

use super::convention::{quaternion_of, rotor_of};
use crate::cga3::{Motor, Point, Rotor, Translator, Vector3};

/// The point n_o + x + ½ x² n_∞ at position x.
impl<T: Field> From<Point3<T>> for Point<T> {
    fn from(point: Point3<T>) -> Self {
        Point::from(Vector3::from(point.coords))
    }
}

/// The position of a point, which its weight of 1 leaves as it stands.
impl<T: Field> From<Point<T>> for Point3<T> {
    fn from(point: Point<T>) -> Self {
        Point3::from(point.position().to_array())
    }
}

/// The rotor w − x e23 + y e13 − z e12 of the quaternion w + x i + y j + z k.
impl<T: Scalar> From<UnitQuaternion<T>> for Rotor<T> {
    fn from(quaternion: UnitQuaternion<T>) -> Self {
        let [[x, y, z, w]] = quaternion.into_inner().coords.data.0;
        rotor_of([w, x, y, z])
    }
}

/// The quaternion s − e23 i + e13 j − e12 k of a rotor, without normalising it.
impl<T: Scalar> From<Rotor<T>> for UnitQuaternion<T> {
    fn from(rotor: Rotor<T>) -> Self {
        let [w, x, y, z] = quaternion_of(rotor);
        Unit::new_unchecked(Quaternion::new(w, x, y, z))
    }
}

/// The translator 1 − ½ v n_∞ of the translation by v.
impl<T: Field> From<Translation3<T>> for Translator<T> {
    fn from(translation: Translation3<T>) -> Self {
        Translator::by(Vector3::from(translation.vector))
    }
}

/// The translation by v of the translator 1 − ½ v n_∞.
impl<T: Field> From<Translator<T>> for Translation3<T> {
    fn from(translator: Translator<T>) -> Self {
        Translation3::from(translator.vector().to_array())
    }
}

/// The motor `T R` of the isometry that turns by R and then translates by T.
impl<T: Field> From<Isometry3<T>> for Motor<T> {
    fn from(isometry: Isometry3<T>) -> Self {
        Translator::from(isometry.translation).geometric(Rotor::from(isometry.rotation))
    }
}

/// The isometry of a motor `M = T R`: R is the part of M without n_∞, and `T = M R̃`.
impl<T: Field> From<Motor<T>> for Isometry3<T> {
    fn from(motor: Motor<T>) -> Self {
        let rotor = Rotor::new(motor.s, motor.e12, motor.e13, motor.e23);
        let shift = motor.geometric(rotor.reverse());
        Isometry3 {
            rotation: rotor.into(),
            translation: Translator::new(shift.e1ni, shift.e2ni, shift.e3ni).into(),
        }
    }
}
