//! How a change of basis at the end of a Hall symbol is read and carried out.

use num_rational::Ratio;

use super::super::operation::{DENOMINATOR, Operation, affine};
use super::ChangeError;

type Exact = Ratio<i128>;
type Matrix = [[Exact; 3]; 3];

/// An affine map from old to new coordinates, and the inverse of its linear part.
///
/// Entries are at most 12 and whole twelfths, so that 128-bit fractions cannot overflow.
#[derive(Clone, Copy, Debug)]
pub struct ChangeOfBasis {
    linear: Matrix,
    inverse: Matrix,
    shift: [Exact; 3],
}

impl ChangeOfBasis {
    /// Reads `(0 0 1)` or `(x,y,z)`, brackets included.
    pub fn read(bytes: &[u8]) -> Result<Self, ChangeError> {
        let text = std::str::from_utf8(bytes).map_err(|_| ChangeError::Form)?;
        let inner = text
            .trim()
            .strip_prefix('(')
            .and_then(|rest| rest.strip_suffix(')'))
            .ok_or(ChangeError::Bracket)?;
        let (linear, shift) = if inner.contains(',') {
            triplet(inner)?
        } else {
            (identity(), twelfths(inner)?)
        };
        let bound = Exact::from_integer(12);
        let coarse = |value: &Exact| 12 % value.denom() == 0 && *value <= bound && *value >= -bound;
        let fits = |value: &Exact| i128::from(DENOMINATOR) % value.denom() == 0;
        if !linear.iter().flatten().all(coarse) || !shift.iter().all(fits) {
            return Err(ChangeError::Singular);
        }
        let inverse = inverse(&linear).ok_or(ChangeError::Singular)?;
        Ok(Self {
            linear,
            inverse,
            shift,
        })
    }

    /// The operations in the new basis: `V S V⁻¹` for each, and the old lattice translations,
    /// which may be fractions of the new ones.
    pub fn carry(&self, operations: &[Operation]) -> Result<Vec<Operation>, ChangeError> {
        let mut carried = Vec::with_capacity(operations.len() + 3);
        for axis in 0..3 {
            let image = self.linear.map(|row| row[axis]);
            carried.push(operation(&identity(), &image)?);
        }
        for old in operations {
            let rotation = old.rotation().map(|row| row.map(whole));
            let rotation = product(&product(&self.linear, &rotation), &self.inverse);
            let moved = image(&self.linear, &old.translation_units().map(unit));
            let back = image(&rotation, &self.shift);
            let mut translation = self.shift;
            for ((value, plus), minus) in translation.iter_mut().zip(moved).zip(back) {
                *value += plus - minus;
            }
            carried.push(operation(&rotation, &translation)?);
        }
        Ok(carried)
    }
}

fn triplet(text: &str) -> Result<(Matrix, [Exact; 3]), ChangeError> {
    let map = affine(text)?;
    let wide = |value: Ratio<i64>| Exact::new((*value.numer()).into(), (*value.denom()).into());
    Ok((map.linear.map(|row| row.map(wide)), map.shift.map(wide)))
}

fn twelfths(text: &str) -> Result<[Exact; 3], ChangeError> {
    let mut shift = [whole(0); 3];
    let mut words = text
        .split(|c: char| c.is_whitespace() || c == '_')
        .filter(|w| !w.is_empty());
    for value in &mut shift {
        let number: i8 = words
            .next()
            .and_then(|w| w.parse().ok())
            .ok_or(ChangeError::Form)?;
        *value = Exact::new(number.into(), 12);
    }
    if words.next().is_some() {
        Err(ChangeError::Form)
    } else {
        Ok(shift)
    }
}

fn operation(rotation: &Matrix, translation: &[Exact; 3]) -> Result<Operation, ChangeError> {
    let mut entries = [[0; 3]; 3];
    for (row, exact) in entries.iter_mut().zip(rotation) {
        for (entry, value) in row.iter_mut().zip(exact) {
            *entry = Some(value)
                .filter(|value| value.is_integer())
                .and_then(|value| i32::try_from(*value.numer()).ok())
                .ok_or(ChangeError::NotIntegral)?;
        }
    }
    let scale = i128::from(DENOMINATOR);
    let mut units = [0; 3];
    for (unit, value) in units.iter_mut().zip(translation) {
        if scale % value.denom() != 0 {
            return Err(ChangeError::NotIntegral);
        }
        let scaled = value.numer().rem_euclid(*value.denom()) * (scale / value.denom());
        *unit = i32::try_from(scaled).map_err(|_| ChangeError::NotIntegral)?;
    }
    Operation::from_units(entries, units).ok_or(ChangeError::NotIntegral)
}

fn whole(value: i32) -> Exact {
    Exact::from_integer(value.into())
}

fn unit(value: i32) -> Exact {
    Exact::new(value.into(), DENOMINATOR.into())
}

fn identity() -> Matrix {
    Operation::IDENTITY.rotation().map(|row| row.map(whole))
}

fn image(matrix: &Matrix, vector: &[Exact; 3]) -> [Exact; 3] {
    matrix.map(|row| row[0] * vector[0] + row[1] * vector[1] + row[2] * vector[2])
}

fn product(left: &Matrix, right: &Matrix) -> Matrix {
    left.map(|row| {
        [0, 1, 2].map(|j| row[0] * right[0][j] + row[1] * right[1][j] + row[2] * right[2][j])
    })
}

fn inverse(matrix: &Matrix) -> Option<Matrix> {
    let m = matrix;
    let cofactor = |i: usize, j: usize| {
        let (r1, r2, c1, c2) = ((i + 1) % 3, (i + 2) % 3, (j + 1) % 3, (j + 2) % 3);
        m[r1][c1] * m[r2][c2] - m[r1][c2] * m[r2][c1]
    };
    let determinant =
        m[0][0] * cofactor(0, 0) + m[0][1] * cofactor(0, 1) + m[0][2] * cofactor(0, 2);
    if *determinant.numer() == 0 {
        return None;
    }
    Some([0, 1, 2].map(|i| [0, 1, 2].map(|j| cofactor(j, i) / determinant)))
}
