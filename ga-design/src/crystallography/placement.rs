//! How a symmetry operation becomes at most three reflections and a translation in space.
//!
//! In fractional coordinates an operation `(W, w)` is no isometry to look at; it is one in the
//! metric of its lattice. A measured cell keeps its symmetry only to the last digit, so the metric
//! is averaged over the point group first, `G = Σ WᵀG₀W / |P|`; then `R = M W M⁻¹` with
//! `MᵀM = G` is orthogonal and, after Cartan and Dieudonné, a product of `3 − dim Fix(R)`
//! reflections.

use super::cell::{image, upper_inverse};
use super::{Cell, Operation};

/// Below this size of `R − 1` an orthogonal matrix of a crystal is the identity: the smallest
/// rotation of a lattice is by 60°.
const IDENTITY_TOLERANCE: f64 = 1e-3;

/// The largest relative misfit between a cell and its symmetry that is taken for rounding.
pub const LARGEST_MISFIT: f64 = 0.02;

/// A symmetry operation in Cartesian coordinates: reflections in planes through the origin, then
/// a translation.
#[derive(Clone, Debug, PartialEq)]
pub struct Placement {
    /// The unit normals of the planes, at most three; the **last** reflection acts first, so that
    /// the versor of the product is `n₁ n₂ n₃` in the order of the list.
    pub reflections: Vec<[f64; 3]>,
    /// The translation that follows, in ångström.
    pub translation: [f64; 3],
}

/// Why operations cannot be placed in space.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum PlacementError {
    /// The cell does not have the symmetry that the operations claim.
    #[error(
        "the cell does not have the symmetry of its space group: edges or angles are off by \
         {percent:.1} %; check the cell, or the setting of the group"
    )]
    Misfit {
        /// The relative misfit of the worst metric coefficient, in percent.
        percent: f64,
    },
}

impl Placement {
    /// The image of a Cartesian point, in ångström.
    pub fn apply(&self, point: [f64; 3]) -> [f64; 3] {
        let mut image = point;
        for normal in self.reflections.iter().rev() {
            image = reflected(image, *normal);
        }
        [0, 1, 2].map(|i| image[i] + self.translation[i])
    }

    /// The placements of operations that form a group, one for each, and the cell that has their
    /// symmetry exactly: it differs from the given one by the rounding of its parameters.
    ///
    /// # Errors
    /// [`PlacementError::Misfit`] when the cell is off by more than [`LARGEST_MISFIT`].
    pub fn of_group(
        operations: &[Operation],
        cell: &Cell,
    ) -> Result<(Vec<Self>, SymmetricCell), PlacementError> {
        let symmetric = SymmetricCell::new(operations, cell)?;
        let placements = operations
            .iter()
            .map(|op| symmetric.placement(op))
            .collect();
        Ok((placements, symmetric))
    }
}

/// The lattice of a cell after its metric was averaged over the point group; Cartesian axes as in
/// [`Cell`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SymmetricCell {
    basis: [[f64; 3]; 3],
    inverse: [[f64; 3]; 3],
}

impl SymmetricCell {
    /// Averages the metric of `cell` over the matrices of the operations.
    ///
    /// # Errors
    /// [`PlacementError::Misfit`] when the cell is off by more than [`LARGEST_MISFIT`].
    pub fn new(operations: &[Operation], cell: &Cell) -> Result<Self, PlacementError> {
        let given = cell.metric();
        let mut sum = [[0.0; 3]; 3];
        for operation in operations {
            let w = operation.rotation().map(|row| row.map(f64::from));
            for (i, row) in sum.iter_mut().enumerate() {
                for (j, entry) in row.iter_mut().enumerate() {
                    for (k, metric_row) in given.iter().enumerate() {
                        for (l, metric) in metric_row.iter().enumerate() {
                            *entry += w[k][i] * metric * w[l][j];
                        }
                    }
                }
            }
        }
        let count = operations.len().max(1) as f64;
        let metric = if operations.is_empty() {
            given
        } else {
            sum.map(|r| r.map(|v| v / count))
        };
        let misfit = misfit(&metric, &given);
        let lattice = Self::of_metric(&metric).filter(|_| misfit <= LARGEST_MISFIT);
        lattice.ok_or(PlacementError::Misfit {
            percent: 100.0 * misfit,
        })
    }

    /// The Cholesky factor: an upper triangular `M` with `MᵀM` the metric, as in [`Cell::basis`].
    fn of_metric(g: &[[f64; 3]; 3]) -> Option<Self> {
        let a = g[0][0].sqrt();
        let (bx, cx) = (g[0][1] / a, g[0][2] / a);
        let by = (g[1][1] - bx * bx).sqrt();
        let cy = (g[1][2] - bx * cx) / by;
        let cz = (g[2][2] - cx * cx - cy * cy).sqrt();
        let regular = a > 0.0 && by > 0.0 && cz > 0.0;
        let basis = [[a, bx, cx], [0.0, by, cy], [0.0, 0.0, cz]];
        regular.then(|| Self {
            basis,
            inverse: upper_inverse(&basis),
        })
    }

    /// The Cartesian position of a point given in fractions of the edges, in ångström.
    pub fn cartesian(&self, fractional: [f64; 3]) -> [f64; 3] {
        image(&self.basis, fractional)
    }

    /// The fractions of the edges at a Cartesian position.
    pub fn fractional(&self, cartesian: [f64; 3]) -> [f64; 3] {
        image(&self.inverse, cartesian)
    }

    /// The matrix from fractional to Cartesian coordinates, row by row.
    pub fn basis(&self) -> [[f64; 3]; 3] {
        self.basis
    }

    /// The reflections and the translation of one operation of the group averaged over.
    pub fn placement(&self, operation: &Operation) -> Placement {
        Placement {
            reflections: reflections(self.orthogonal(operation)),
            translation: self.cartesian(operation.translation_f64()),
        }
    }

    /// `R = M W M⁻¹`, orthogonal up to rounding.
    pub fn orthogonal(&self, operation: &Operation) -> [[f64; 3]; 3] {
        let w = operation.rotation().map(|row| row.map(f64::from));
        product(&self.basis, &product(&w, &self.inverse))
    }
}

/// The worst deviation of a metric coefficient, in relation to the edges that it joins.
fn misfit(averaged: &[[f64; 3]; 3], given: &[[f64; 3]; 3]) -> f64 {
    let mut worst: f64 = 0.0;
    for i in 0..3 {
        for j in 0..3 {
            let scale = (given[i][i] * given[j][j]).sqrt();
            // A metric coefficient changes twice as fast as an edge.
            worst = worst.max((averaged[i][j] - given[i][j]).abs() / (2.0 * scale));
        }
    }
    worst
}

/// The unit normals of at most three planes whose reflections, the last first, make up the
/// orthogonal matrix `r`.
///
/// Each step takes the coordinate vector that is moved most, `x ↦ y`, and reflects `y` back to
/// `x` in the plane across `x − y`. What was fixed stays fixed, since `x − y` is perpendicular to
/// every fixed vector, so three steps always suffice.
fn reflections(r: [[f64; 3]; 3]) -> Vec<[f64; 3]> {
    let mut rest = r;
    let mut normals = Vec::with_capacity(3);
    for _ in 0..3 {
        let difference = |j: usize| [0, 1, 2].map(|i| f64::from(u8::from(i == j)) - rest[i][j]);
        let moved = [0, 1, 2].map(|j| length(difference(j)));
        let most = [1, 2]
            .into_iter()
            .fold(0, |best, j| if moved[j] > moved[best] { j } else { best });
        if moved[most].is_nan() || moved[most] <= IDENTITY_TOLERANCE {
            break;
        }
        let normal = difference(most).map(|value| value / moved[most]);
        normals.push(normal);
        for j in 0..3 {
            let column = reflected([rest[0][j], rest[1][j], rest[2][j]], normal);
            for (row, value) in rest.iter_mut().zip(column) {
                row[j] = value;
            }
        }
    }
    normals
}

fn reflected(v: [f64; 3], normal: [f64; 3]) -> [f64; 3] {
    let twice = 2.0 * (v[0] * normal[0] + v[1] * normal[1] + v[2] * normal[2]);
    [0, 1, 2].map(|i| v[i] - twice * normal[i])
}

fn length(v: [f64; 3]) -> f64 {
    (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]).sqrt()
}

fn product(left: &[[f64; 3]; 3], right: &[[f64; 3]; 3]) -> [[f64; 3]; 3] {
    left.map(|row| {
        [0, 1, 2].map(|j| row[0] * right[0][j] + row[1] * right[1][j] + row[2] * right[2][j])
    })
}
