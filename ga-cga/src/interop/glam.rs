//! Points and rotations of `glam`, in both of its precisions.

use ::glam::{Affine3A, DAffine3, DMat4, DQuat, DVec3, Mat4, Quat, Vec3};

use super::matrix::{MATRIX_TOLERANCE, MatrixError};
use crate::cga3::{Even, Motor, Point, Rotor, Vector3};

macro_rules! precision {
    ($number:ident $Vector:ident $Quaternion:ident $Affine:ident $Matrix:ident) => {
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
                Rotor::from_quaternion([w, x, y, z])
            }
        }

        /// The quaternion s − e23 i + e13 j − e12 k of a rotor, without normalising it.
        impl From<Rotor<$number>> for $Quaternion {
            fn from(rotor: Rotor<$number>) -> Self {
                let [w, x, y, z] = rotor.to_quaternion();
                $Quaternion::from_xyzw(x, y, z, w)
            }
        }

        /// The rigid motion of a matrix, up to [`MATRIX_TOLERANCE`].
        impl TryFrom<$Matrix> for Motor<$number> {
            type Error = MatrixError;

            fn try_from(matrix: $Matrix) -> Result<Self, MatrixError> {
                let rows = matrix.transpose().to_cols_array_2d();
                Motor::from_matrix(rows, MATRIX_TOLERANCE as $number)
            }
        }

        /// The matrix of a motor of any weight but zero.
        impl TryFrom<Motor<$number>> for $Matrix {
            type Error = MatrixError;

            fn try_from(motor: Motor<$number>) -> Result<Self, MatrixError> {
                let rows = motor.to_matrix().ok_or(MatrixError::NoMatrix)?;
                Ok($Matrix::from_cols_array_2d(&rows).transpose())
            }
        }

        /// The similarity of a matrix, up to [`MATRIX_TOLERANCE`].
        impl TryFrom<$Matrix> for Even<$number> {
            type Error = MatrixError;

            fn try_from(matrix: $Matrix) -> Result<Self, MatrixError> {
                let rows = matrix.transpose().to_cols_array_2d();
                Even::from_matrix(rows, MATRIX_TOLERANCE as $number)
            }
        }

        /// The matrix of a versor that is a similarity, up to [`MATRIX_TOLERANCE`].
        impl TryFrom<Even<$number>> for $Matrix {
            type Error = MatrixError;

            fn try_from(versor: Even<$number>) -> Result<Self, MatrixError> {
                let rows = versor.to_matrix(MATRIX_TOLERANCE as $number);
                let rows = rows.ok_or(MatrixError::NoMatrix)?;
                Ok($Matrix::from_cols_array_2d(&rows).transpose())
            }
        }

        /// The rigid motion of an affine map, up to [`MATRIX_TOLERANCE`].
        impl TryFrom<$Affine> for Motor<$number> {
            type Error = MatrixError;

            fn try_from(map: $Affine) -> Result<Self, MatrixError> {
                Motor::try_from($Matrix::from(map))
            }
        }

        /// The affine map of a motor of any weight but zero.
        impl TryFrom<Motor<$number>> for $Affine {
            type Error = MatrixError;

            fn try_from(motor: Motor<$number>) -> Result<Self, MatrixError> {
                Ok($Affine::from_mat4($Matrix::try_from(motor)?))
            }
        }
    };
}

precision!(f32 Vec3 Quat Affine3A Mat4);
precision!(f64 DVec3 DQuat DAffine3 DMat4);
