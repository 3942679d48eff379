//! Motions and similarities as 4×4 matrices: which versor a matrix is, and when it is none.
//!
//! A matrix is a list of rows, `matrix[row][column]`, and stands on the left of the column
//! (x, y, z, 1): the last column is the translation and the last row is 0 0 0 1.

use core::fmt;

use ga_core::Real;

use crate::cga3::{Dilator, Even, Motor, Rotor, Translator, Trivector3, Vector3};
use crate::classify::range::within_range;

/// The error up to which `TryFrom` takes a matrix for one of a motion or a similarity, against
/// its scale: it lets matrices of single precision pass.
pub const MATRIX_TOLERANCE: f64 = 1e-5;

/// Why a matrix is no versor of the kind asked for, or a versor has no matrix.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum MatrixError {
    /// A number of the matrix is infinite or not a number.
    NotFinite,
    /// The last row is not 0 0 0 1: the matrix is a projection.
    Projective,
    /// The columns of the linear part are not at right angles and of equal length.
    NotSimilar,
    /// The matrix scales, and a rigid motion was asked for.
    Scales,
    /// The matrix reflects, and a rigid motion was asked for.
    Reflects,
    /// The versor is null, or it is no similarity and bends straight lines.
    NoMatrix,
}

impl fmt::Display for MatrixError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            MatrixError::NotFinite => "a number of the matrix is not finite",
            MatrixError::Projective => {
                "the last row of the matrix is not 0 0 0 1; only affine matrices are conformal, \
                 and a matrix stored by columns has to be transposed"
            }
            MatrixError::NotSimilar => {
                "the columns of the matrix are not at right angles and of equal length; \
                 orthonormalise it, or allow a larger tolerance"
            }
            MatrixError::Scales => {
                "the matrix scales, which no motor does; convert it to an `Even` versor"
            }
            MatrixError::Reflects => {
                "the matrix reflects, which no motor does; convert it to an `Even` versor"
            }
            MatrixError::NoMatrix => {
                "the versor is null or bends straight lines; only similarities have a matrix"
            }
        })
    }
}

impl core::error::Error for MatrixError {}

impl<T: Real> Rotor<T> {
    /// The 3×3 matrix of the rotation, by rows; `None` for zero.
    ///
    /// ```
    /// use ga_cga::{Bivector3, Rotor};
    ///
    /// let quarter = Rotor::turn(Bivector3::new(1.0, 0.0, 0.0), core::f64::consts::FRAC_PI_2);
    /// let [[xx, xy, _], [yx, yy, _], [_, _, zz]] = quarter.unwrap().to_matrix().unwrap();
    /// assert!(xx.abs() + (xy + 1.0).abs() + (yx - 1.0).abs() + yy.abs() < 1e-15);
    /// assert!((zz - 1.0_f64).abs() < 1e-15);
    /// ```
    pub fn to_matrix(self) -> Option<[[T; 3]; 3]> {
        let rotor = within_range(self)?.normalized()?;
        let [x, y, z] = axes().map(|axis| rotor.apply(axis).to_array());
        Some(core::array::from_fn(|row| [x[row], y[row], z[row]]))
    }

    /// The rotation of a 3×3 matrix, by rows, of the two rotors the one with a scalar part of at
    /// least zero.
    ///
    /// The columns are the images of the axes: one rotor takes x to its image, another about
    /// that takes y to its own (2.38). This is exact to rounding for half turns as well.
    ///
    /// # Errors
    /// [`MatrixError`] if the matrix is not that of a rotation within `tolerance`.
    pub fn from_matrix(matrix: [[T; 3]; 3], tolerance: T) -> Result<Self, MatrixError> {
        let (factor, rotor) = scaled_rotation(matrix, tolerance)?;
        rigid(factor, tolerance)?;
        Ok(rotor)
    }
}

impl<T: Real> Motor<T> {
    /// The 4×4 matrix of the motion, by rows; `None` for motors without a rotation, which are no
    /// versors.
    ///
    /// ```
    /// use ga_cga::{Motor, Translator, Vector3};
    ///
    /// let shift = Motor::from(Translator::by(Vector3::new(1.0, 2.0, 3.0)));
    /// let matrix = shift.to_matrix().unwrap();
    /// assert_eq!(matrix[0], [1.0, 0.0, 0.0, 1.0]);
    /// assert_eq!(matrix[3], [0.0, 0.0, 0.0, 1.0]);
    /// assert_eq!(Motor::from_matrix(matrix, 1e-9), Ok(shift));
    /// ```
    pub fn to_matrix(self) -> Option<[[T; 4]; 4]> {
        let rotation = self.rotation()?.to_matrix()?;
        Some(affine(rotation, self.translation()?))
    }

    /// The motion of a 4×4 matrix, by rows; of the two motors the one whose scalar part is at
    /// least zero.
    ///
    /// # Errors
    /// [`MatrixError`] if the matrix is not that of a rigid motion without reflection. The
    /// lengths and angles of the columns may be off by `tolerance`, against one.
    pub fn from_matrix(matrix: [[T; 4]; 4], tolerance: T) -> Result<Self, MatrixError> {
        let (linear, translation) = parts(matrix, tolerance)?;
        let rotation = Rotor::from_matrix(linear, tolerance)?;
        Ok(Motor::rigid(rotation, translation))
    }
}

impl<T: Real> Even<T> {
    /// The 4×4 matrix of a similarity, by rows; `None` if the versor is null, or no similarity
    /// within `tolerance` as [`similarity_parts`](Even::similarity_parts) has it.
    pub fn to_matrix(self, tolerance: T) -> Option<[[T; 4]; 4]> {
        let (scaling, rotation, translation) = self.similarity_parts(tolerance)?;
        let factor = scaling.factor()?;
        let linear = rotation.to_matrix()?.map(|row| row.map(|c| c * factor));
        Some(affine(linear, translation))
    }

    /// The similarity of a 4×4 matrix, by rows. A matrix that reflects is one that scales by a
    /// negative factor.
    ///
    /// ```
    /// use ga_cga::{Even, Point};
    ///
    /// let mirror_and_double = [
    ///     [2.0, 0.0, 0.0, 1.0],
    ///     [0.0, 2.0, 0.0, 0.0],
    ///     [0.0, 0.0, -2.0, 0.0],
    ///     [0.0, 0.0, 0.0, 1.0],
    /// ];
    /// let versor = Even::from_matrix(mirror_and_double, 1e-9).unwrap();
    /// let image = Point::at(1.0, 2.0, 3.0).image_under(versor).unwrap();
    /// assert!(image.distance(Point::at(3.0, 4.0, -6.0)) < 1e-14);
    /// ```
    ///
    /// # Errors
    /// [`MatrixError`] if the matrix is not that of a similarity. The lengths and angles of the
    /// columns may be off by `tolerance`, against the scale.
    pub fn from_matrix(matrix: [[T; 4]; 4], tolerance: T) -> Result<Self, MatrixError> {
        let (linear, translation) = parts(matrix, tolerance)?;
        let (factor, rotation) = scaled_rotation(linear, tolerance)?;
        let scaling = Dilator::scaling(factor).ok_or(MatrixError::NotSimilar)?;
        Ok(Even::similarity(scaling, rotation, translation))
    }
}

fn axes<T: Real>() -> [Vector3<T>; 3] {
    let (zero, one) = (T::ZERO, T::ONE);
    [
        Vector3::new(one, zero, zero),
        Vector3::new(zero, one, zero),
        Vector3::new(zero, zero, one),
    ]
}

/// The linear part and the translation of an affine matrix.
fn parts<T: Real>(
    matrix: [[T; 4]; 4],
    tolerance: T,
) -> Result<([[T; 3]; 3], Translator<T>), MatrixError> {
    let [x, y, z, last] = matrix;
    if !matrix.into_iter().flatten().all(T::is_finite) {
        return Err(MatrixError::NotFinite);
    }
    let affine = [T::ZERO, T::ZERO, T::ZERO, T::ONE];
    let same = |(have, want): (T, T)| (have - want).abs().all_le(tolerance);
    if !last.into_iter().zip(affine).all(same) {
        return Err(MatrixError::Projective);
    }
    let linear = [x, y, z].map(|[a, b, c, _]| [a, b, c]);
    let translation = Translator::by(Vector3::new(x[3], y[3], z[3]));
    Ok((linear, translation))
}

fn affine<T: Real>(linear: [[T; 3]; 3], translation: Translator<T>) -> [[T; 4]; 4] {
    let shift = translation.vector().to_array();
    let row = |row: usize| {
        let [a, b, c] = linear[row];
        [a, b, c, shift[row]]
    };
    let last = [T::ZERO, T::ZERO, T::ZERO, T::ONE];
    [row(0), row(1), row(2), last]
}

/// The factor and the rotation that a linear similarity consists of; the factor is negative for
/// one that reflects.
fn scaled_rotation<T: Real>(
    linear: [[T; 3]; 3],
    tolerance: T,
) -> Result<(T, Rotor<T>), MatrixError> {
    if !linear.into_iter().flatten().all(T::is_finite) {
        return Err(MatrixError::NotFinite);
    }
    let columns: [Vector3<T>; 3] =
        core::array::from_fn(|i| Vector3::from(linear.map(|row| row[i])));
    let [Some(x), Some(y), Some(z)] = columns.map(Vector3::normalized) else {
        return Err(MatrixError::NotSimilar);
    };
    let size = columns[0].norm();
    let even = |column: Vector3<T>| (column.norm() / size - T::ONE).abs().all_le(tolerance);
    let right = |a: Vector3<T>, b: Vector3<T>| a.scalar_product(b).abs().all_le(tolerance);
    if !columns.into_iter().all(even) || !right(x, y) || !right(y, z) || !right(z, x) {
        return Err(MatrixError::NotSimilar);
    }
    let Trivector3 { e123: volume } = x ^ y ^ z;
    let factor = if T::ZERO.all_le(volume) { size } else { -size };
    let sign = factor / size;
    let (x, y) = (x * sign, y * sign);
    let [e1, e2, _] = axes::<T>();
    let first = Rotor::between_in(e1, x, e1 ^ e2).ok_or(MatrixError::NotSimilar)?;
    // The other turns about x, so its plane is known and only the angle is asked for.
    let plane = x * Trivector3::new(T::ONE);
    let from = first.apply(e2);
    let ahead = from.left_contract(plane);
    let angle = y.scalar_product(ahead).atan2(y.scalar_product(from));
    let second = Rotor::turn(plane, angle).ok_or(MatrixError::NotSimilar)?;
    let rotor = (second * first)
        .normalized()
        .ok_or(MatrixError::NotSimilar)?;
    let positive = T::ZERO.all_le(rotor.s);
    Ok((factor, if positive { rotor } else { -rotor }))
}

/// Whether a similarity of this factor is a motion.
fn rigid<T: Real>(factor: T, tolerance: T) -> Result<(), MatrixError> {
    if !(factor.abs() - T::ONE).abs().all_le(tolerance) {
        Err(MatrixError::Scales)
    } else if !T::ZERO.all_le(factor) {
        Err(MatrixError::Reflects)
    } else {
        Ok(())
    }
}
