//! Collineations from 4×4 matrices: generators, elations, scalings, and the general matrix by
//! elimination.

use ga_core::{Field, Real};

use super::{Bivector, Collineation, Direction, IdealBivector, Line, Moment, OriginBivector};

/// A matrix that acts on homogeneous columns x, y, z, w, by rows.
type Matrix<T> = [[T; 4]; 4];

impl<T: Field> Bivector<T> {
    /// The generator B with e^B the collineation e^M, for a 4×4 matrix M; its trace, which only
    /// changes weights, is taken out.
    ///
    /// The 15 bivectors are the 15 matrices without trace: `m`∧`m` moves the origin, `d`∧`d` the
    /// plane at infinity, and `d`∧`m` is linear.
    pub fn generator(matrix: Matrix<T>) -> Self {
        let trace = (0..4).fold(T::ZERO, |sum, i| sum + matrix[i][i]);
        // The rows of the linear part see a quarter of the trace less, and the weight taken out.
        let weight = matrix[3][3] - trace * T::from_ratio(1, 2);
        let [r1, r2, r3, [a, b, c, _]] = matrix;
        let shift = IdealBivector::new(-r1[3], -r2[3], -r3[3]);
        let perspective = OriginBivector::new(a, b, c);
        let along = |i: usize| {
            let [x, y, z] = core::array::from_fn(|j| if i == j { T::ONE } else { T::ZERO });
            Direction::new(x, y, z)
        };
        let linear = [r1, r2, r3].into_iter().enumerate().map(|(i, mut row)| {
            row[i] += weight;
            along(i) ^ Moment::new(row[0], row[1], row[2])
        });
        let sum = linear.fold(
            Bivector::from(shift) + Bivector::from(perspective),
            |a, b| a + b,
        );
        sum * T::from_ratio(1, 2)
    }
}

impl<T: Field> Collineation<T> {
    /// The identity.
    pub fn identity() -> Self {
        Collineation {
            s: T::ONE,
            ..Collineation::default()
        }
    }

    /// The elation x ↦ x + (φ·x) c with its centre c, a point, on its axis φ, a plane, by their
    /// homogeneous coordinates: a translation where both are at infinity, a shear where the
    /// centre is, a perspective otherwise. It is 1 + B with the pencil B of lines through c in φ.
    /// `None` where the point is not on the plane, exactly.
    pub fn elation(center: [T; 4], axis: [T; 4]) -> Option<Self> {
        let incident = (0..4).fold(T::ZERO, |sum, i| sum + axis[i] * center[i]);
        let pencil = Bivector::generator(center.map(|c| axis.map(|a| c * a)));
        (!incident.is_invertible()).then(|| Collineation::identity() + Collineation::from(pencil))
    }

    /// The translation by a vector.
    pub fn translation([x, y, z]: [T; 3]) -> Self {
        let half = T::from_ratio(-1, 2);
        let shift = IdealBivector::new(x * half, y * half, z * half);
        Collineation::identity() + Collineation::from(shift)
    }
}

impl<T: Real> Collineation<T> {
    /// The exponential of a generator: e^M of the matrix that it is the
    /// [`generator`](Bivector::generator) of.
    pub fn from_generator(generator: Bivector<T>) -> Self {
        generator.exp()
    }

    /// The scaling by a factor along each axis, as product of two correlations for each;
    /// `None` unless the product of the factors is positive and finite.
    pub fn scaling(factors: [T; 3]) -> Option<Self> {
        let [x, y, z] = factors;
        let volume = x * y * z;
        if volume.all_le(T::ZERO) || !volume.is_finite() {
            return None;
        }
        let root = volume.sqrt();
        let mut all = Collineation::identity();
        for (axis, factor) in factors.into_iter().enumerate() {
            // (d + k m)(d + m) scales d by k and m by 1/k.
            let mirror = |k: T| {
                let mut coefficients = [T::ZERO; 6];
                coefficients[axis] = T::ONE;
                coefficients[axis + 3] = k;
                Line::from(coefficients)
            };
            all = all * (mirror(root / factor) * mirror(T::ONE));
        }
        all.balanced()
    }

    /// The collineation of a 4×4 matrix that acts on columns of homogeneous coordinates; `None`
    /// unless its determinant is positive and its entries are finite.
    ///
    /// The matrix is cleared by elations, row by row with the largest pivot added first, until a
    /// scaling is left.
    pub fn from_matrix(matrix: [[T; 4]; 4]) -> Option<Self> {
        let mut rest = matrix;
        let mut versor = Collineation::identity();
        for column in 0..4 {
            let pivot = (column..4).fold(column, |best, row| {
                if rest[row][column].abs().all_le(rest[best][column].abs()) {
                    best
                } else {
                    row
                }
            });
            if pivot != column {
                // Of either sign, so that the sum is the larger one.
                let opposite = (rest[pivot][column] * rest[column][column]).all_le(T::ZERO);
                let sign = if opposite { -T::ONE } else { T::ONE };
                versor = versor * add_row(&mut rest, column, pivot, sign)?;
            }
            if !rest[column][column].is_invertible() {
                return None;
            }
            for row in (0..4).filter(|row| *row != column) {
                let factor = -rest[row][column] / rest[column][column];
                versor = versor * add_row(&mut rest, row, column, factor)?;
            }
            versor = versor.balanced()?;
        }
        let weight = rest[3][3];
        let scaling = Collineation::scaling([0, 1, 2].map(|i| rest[i][i] / weight))?;
        (versor * scaling).balanced()
    }

    /// The same collineation with its largest coefficient 1; `None` where that is zero or not
    /// finite. Products of many versors stay in range this way.
    fn balanced(self) -> Option<Self> {
        let size = self.to_array().into_iter().fold(T::ZERO, |size, x| {
            if x.abs().all_le(size) { size } else { x.abs() }
        });
        // A coefficient that is not a number is not the largest one, and the inverse of a small one
        // is not finite.
        let scaled = self * (T::ONE / size);
        let finite = scaled.to_array().into_iter().all(T::is_finite);
        (size.is_finite() && finite).then_some(scaled)
    }
}

/// Adds a multiple of one row to another, and returns the elation that undoes it.
fn add_row<T: Real>(
    matrix: &mut Matrix<T>,
    row: usize,
    from: usize,
    factor: T,
) -> Option<Collineation<T>> {
    let source = matrix[from];
    for (entry, addend) in matrix[row].iter_mut().zip(source) {
        *entry += addend * factor;
    }
    let unit = |i: usize, size: T| core::array::from_fn(|j| if i == j { size } else { T::ZERO });
    Collineation::elation(unit(row, -factor), unit(from, T::ONE))
}
