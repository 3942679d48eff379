//! Points and motions of `nalgebra`.

use ::nalgebra::{
    DualQuaternion, Isometry3, Matrix3, Matrix4, Point3, Quaternion, RealField, Similarity3,
    Translation3, Unit, UnitDualQuaternion, UnitQuaternion,
};
use ga_core::{Field, Real, Scalar};

use super::matrix::{MATRIX_TOLERANCE, MatrixError};
use crate::cga3::{Dilator, Even, Motor, Point, Rotor, Translator, Vector3};

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
        Rotor::from_quaternion([w, x, y, z])
    }
}

/// The quaternion s − e23 i + e13 j − e12 k of a rotor, without normalising it.
impl<T: Scalar> From<Rotor<T>> for UnitQuaternion<T> {
    fn from(rotor: Rotor<T>) -> Self {
        let [w, x, y, z] = rotor.to_quaternion();
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

/// The motor of the dual quaternion q + ε p, with ε = −**I**₃ n_∞.
impl<T: Scalar> From<UnitDualQuaternion<T>> for Motor<T> {
    fn from(quaternion: UnitDualQuaternion<T>) -> Self {
        let DualQuaternion { real, dual } = quaternion.into_inner();
        Motor::from_dual_quaternion([real, dual].map(|part| {
            let [[x, y, z, w]] = part.coords.data.0;
            [w, x, y, z]
        }))
    }
}

/// The dual quaternion q + ε p of a motor, without normalising it.
impl<T: Scalar + RealField> From<Motor<T>> for UnitDualQuaternion<T> {
    fn from(motor: Motor<T>) -> Self {
        let [real, dual] = motor
            .to_dual_quaternion()
            .map(|[w, x, y, z]| Quaternion::new(w, x, y, z));
        Unit::new_unchecked(DualQuaternion::from_real_and_dual(real, dual))
    }
}

/// The rotation of a matrix, up to [`MATRIX_TOLERANCE`].
impl<T: Real> TryFrom<Matrix3<T>> for Rotor<T> {
    type Error = MatrixError;

    fn try_from(matrix: Matrix3<T>) -> Result<Self, MatrixError> {
        let matrix: [[T; 3]; 3] = matrix.transpose().into();
        Rotor::from_matrix(matrix, T::from_f64(MATRIX_TOLERANCE))
    }
}

/// The rigid motion of a matrix, up to [`MATRIX_TOLERANCE`].
impl<T: Real> TryFrom<Matrix4<T>> for Motor<T> {
    type Error = MatrixError;

    fn try_from(matrix: Matrix4<T>) -> Result<Self, MatrixError> {
        let matrix: [[T; 4]; 4] = matrix.transpose().into();
        Motor::from_matrix(matrix, T::from_f64(MATRIX_TOLERANCE))
    }
}

/// The matrix of a motor of any weight but zero.
impl<T: Real> TryFrom<Motor<T>> for Matrix4<T> {
    type Error = MatrixError;

    fn try_from(motor: Motor<T>) -> Result<Self, MatrixError> {
        let rows = motor.to_matrix().ok_or(MatrixError::NoMatrix)?;
        Ok(Matrix4::from(rows).transpose())
    }
}

/// The similarity of a matrix, up to [`MATRIX_TOLERANCE`].
impl<T: Real> TryFrom<Matrix4<T>> for Even<T> {
    type Error = MatrixError;

    fn try_from(matrix: Matrix4<T>) -> Result<Self, MatrixError> {
        let matrix: [[T; 4]; 4] = matrix.transpose().into();
        Even::from_matrix(matrix, T::from_f64(MATRIX_TOLERANCE))
    }
}

/// The matrix of a versor that is a similarity, up to [`MATRIX_TOLERANCE`].
impl<T: Real> TryFrom<Even<T>> for Matrix4<T> {
    type Error = MatrixError;

    fn try_from(versor: Even<T>) -> Result<Self, MatrixError> {
        let rows = versor.to_matrix(T::from_f64(MATRIX_TOLERANCE));
        Ok(Matrix4::from(rows.ok_or(MatrixError::NoMatrix)?).transpose())
    }
}

/// The versor T R D of the similarity that scales first, turns then and translates last.
impl<T: Real + RealField> TryFrom<Similarity3<T>> for Even<T> {
    type Error = MatrixError;

    fn try_from(similarity: Similarity3<T>) -> Result<Self, MatrixError> {
        let scaling = Dilator::scaling(similarity.scaling()).ok_or(MatrixError::NotSimilar)?;
        let Isometry3 {
            rotation,
            translation,
        } = similarity.isometry;
        Ok(Even::similarity(
            scaling,
            rotation.into(),
            translation.into(),
        ))
    }
}

/// The similarity that a versor is, up to [`MATRIX_TOLERANCE`].
impl<T: Real + RealField> TryFrom<Even<T>> for Similarity3<T> {
    type Error = MatrixError;

    fn try_from(versor: Even<T>) -> Result<Self, MatrixError> {
        let parts = versor.similarity_parts(<T as Real>::from_f64(MATRIX_TOLERANCE));
        let (scaling, rotation, translation) = parts.ok_or(MatrixError::NoMatrix)?;
        let factor = scaling.factor().ok_or(MatrixError::NoMatrix)?;
        Ok(Similarity3::from_parts(
            translation.into(),
            rotation.into(),
            factor,
        ))
    }
}
