//! How a lattice direction is completed to a basis of the lattice, so that positions across it can be
//! compared modulo the lattice.

use num_rational::Ratio;

/// An exact fraction of a cell edge.
pub type Fraction = Ratio<i64>;

/// The largest absolute value of an index that is accepted. Those of conventional settings are at
/// most 3; with this bound no product of what is computed from them can overflow.
const LARGEST_INDEX: i64 = 64;

/// The same direction with coprime indices, the first that is not zero positive; `None` for zero and
/// for indices that are coprime beyond 64.
pub(super) fn primitive(vector: [i64; 3]) -> Option<[i64; 3]> {
    if vector.iter().any(|index| index.unsigned_abs() > 1 << 40) {
        return None;
    }
    let divisor = vector.into_iter().fold(0, gcd);
    let first = vector.into_iter().find(|index| *index != 0)?;
    let reduced = vector.map(|index| index / divisor * first.signum());
    let fits = reduced.iter().all(|index| index.abs() <= LARGEST_INDEX);
    fits.then_some(reduced)
}

fn gcd(a: i64, b: i64) -> i64 {
    if b == 0 { a.abs() } else { gcd(b, a % b) }
}

/// Coordinates in which a primitive lattice vector `d` is the third basis vector: the matrix `U` with
/// `U d = (0, 0, 1)`, of integers and determinant ±1, so that the lattice of all integer vectors stays
/// the lattice of all integer vectors.
#[derive(Clone, Copy, Debug)]
pub(super) struct LatticeBasis {
    rows: [[i64; 3]; 3],
    inverse: [[i64; 3]; 3],
}

impl LatticeBasis {
    /// The basis that Euclid's algorithm on the indices ends with.
    pub(super) fn completing(direction: [i64; 3]) -> Self {
        let mut rows = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
        let mut left = direction;
        loop {
            let nonzero = (0..3).filter(|&i| left[i] != 0);
            let Some(smallest) = nonzero.min_by_key(|&i| left[i].abs()) else {
                break;
            };
            for i in (0..3).filter(|&i| i != smallest) {
                let times = left[i] / left[smallest];
                left[i] -= times * left[smallest];
                rows[i] = [0, 1, 2].map(|k| rows[i][k] - times * rows[smallest][k]);
            }
            if (0..3).filter(|&i| left[i] != 0).count() == 1 {
                let sign = left[smallest].signum();
                rows[smallest] = rows[smallest].map(|entry| sign * entry);
                rows.swap(smallest, 2);
                break;
            }
        }
        Self {
            rows,
            inverse: inverse(&rows),
        }
    }

    /// The coordinates `U x` of a point.
    pub(super) fn coordinates(&self, point: [Fraction; 3]) -> [Fraction; 3] {
        image(&self.rows, point)
    }

    /// The point with these coordinates.
    pub(super) fn point(&self, coordinates: [Fraction; 3]) -> [Fraction; 3] {
        image(&self.inverse, coordinates)
    }

    /// The position with these coordinates, in floating point.
    pub(super) fn position(&self, coordinates: [f64; 3]) -> [f64; 3] {
        let value = |row: [i64; 3]| (0..3).map(|k| row[k] as f64 * coordinates[k]).sum();
        self.inverse.map(value)
    }

    /// The rows of `U`: the integer forms that are 0, 0 and 1 on the direction.
    pub(super) fn forms(&self) -> [[i64; 3]; 3] {
        self.rows
    }

    /// The matrix of a map in these coordinates, `U W U⁻¹`.
    pub(super) fn matrix(&self, map: &[[i64; 3]; 3]) -> [[i64; 3]; 3] {
        product(&self.rows, &product(map, &self.inverse))
    }
}

/// The image of a point under an integer matrix.
pub(super) fn image(matrix: &[[i64; 3]; 3], point: [Fraction; 3]) -> [Fraction; 3] {
    matrix.map(|row| dot(row, point))
}

/// The value of an integer form at a point.
pub(super) fn dot(form: [i64; 3], point: [Fraction; 3]) -> Fraction {
    let terms = form.into_iter().zip(point);
    terms.map(|(index, coordinate)| coordinate * index).sum()
}

/// The part of a fraction that is left modulo 1, in `[0, 1)`.
pub(super) fn modulo_one(fraction: Fraction) -> Fraction {
    fraction - fraction.floor()
}

pub(super) fn product(left: &[[i64; 3]; 3], right: &[[i64; 3]; 3]) -> [[i64; 3]; 3] {
    left.map(|row| [0, 1, 2].map(|j| (0..3).map(|k| row[k] * right[k][j]).sum()))
}

/// The inverse of an integer matrix of determinant ±1.
fn inverse(m: &[[i64; 3]; 3]) -> [[i64; 3]; 3] {
    // The adjugate, its signs carried by the cyclic order of the indices.
    let adjugate = [0, 1, 2].map(|i: usize| {
        [0, 1, 2].map(|j: usize| {
            let (r1, r2) = ((j + 1) % 3, (j + 2) % 3);
            let (c1, c2) = ((i + 1) % 3, (i + 2) % 3);
            m[r1][c1] * m[r2][c2] - m[r1][c2] * m[r2][c1]
        })
    });
    let determinant: i64 = (0..3).map(|k| m[0][k] * adjugate[k][0]).sum();
    adjugate.map(|row| row.map(|entry| entry * determinant))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_direction_becomes_the_third_basis_vector() {
        let all =
            (-5..=5).flat_map(|i| (-5..=5).flat_map(move |j| (-5..=5).map(move |k| [i, j, k])));
        for vector in all {
            let Some(direction) = primitive(vector) else {
                assert_eq!(vector, [0, 0, 0]);
                continue;
            };
            let basis = LatticeBasis::completing(direction);
            let whole = direction.map(Fraction::from);
            assert_eq!(basis.coordinates(whole), [0, 0, 1].map(Fraction::from));
            let unit = product(&basis.rows, &basis.inverse);
            assert_eq!(unit, [[1, 0, 0], [0, 1, 0], [0, 0, 1]], "{direction:?}");
        }
    }

    #[test]
    fn directions_are_reduced_and_turned_forward() {
        assert_eq!(primitive([0, -4, 2]), Some([0, 2, -1]));
        assert_eq!(primitive([0, 0, 0]), None);
        assert_eq!(primitive([128, 2, 0]), Some([64, 1, 0]));
        assert_eq!(primitive([65, 1, 0]), None);
    }
}
