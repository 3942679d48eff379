//! Which forces hold a structure in balance without any load, and which displacements lengthen no
//! member: the four subspaces of the equilibrium matrix.
//!
//! S. Pellegrino and C. R. Calladine, “Matrix analysis of statically and kinematically indeterminate
//! frameworks”, *Int. J. Solids Structures* 22 (1986) 409–428; S. Pellegrino, “Structural computations
//! with the singular value decomposition of the equilibrium matrix”, ibid. 30 (1993) 3025–3035.

use super::TensegrityError;
use super::structure::Structure;
use nalgebra::{DMatrix, DVector, Dyn, SVD};

/// Singular values below this part of the largest are zero.
pub(super) const RANK_TOLERANCE: f64 = 1e-9;

/// The sweeps after which a decomposition is given up; it needs a handful.
const SWEEPS: usize = 10_000;

/// What the equilibrium matrix says about a structure.
#[derive(Debug, Clone)]
pub(super) struct Equilibrium {
    /// An orthonormal basis of the self-stresses, as columns: the force in each member.
    pub self_stresses: DMatrix<f64>,
    /// An orthonormal basis of the displacements that lengthen members, as columns.
    pub lengthening: DMatrix<f64>,
    /// An orthonormal basis of the rigid motions, as columns.
    pub rigid: DMatrix<f64>,
}

impl Equilibrium {
    /// The number of infinitesimal mechanisms, rigid motions not counted.
    pub fn mechanisms(&self) -> usize {
        let freedoms = self.rigid.nrows();
        freedoms.saturating_sub(self.lengthening.ncols() + self.rigid.ncols())
    }

    /// The subspaces of a structure.
    pub fn of(structure: &Structure) -> Result<Self, TensegrityError> {
        let matrix = directions(structure);
        let members = matrix.ncols();
        // A square of the larger side has full bases on both sides.
        let rows = matrix.nrows().max(members);
        let padded = matrix.resize_vertically(rows, 0.0);
        let freedoms = 3 * structure.nodes().len();
        let parts = decompose(padded, true)?;
        let rank = rank(&parts);
        let (Some(left), Some(right)) = (parts.u, parts.v_t) else {
            return Err(TensegrityError::Undecided);
        };
        Ok(Self {
            self_stresses: right.rows(rank, members - rank).transpose(),
            lengthening: left.view((0, 0), (freedoms, rank)).into_owned(),
            rigid: rigid_motions(structure)?,
        })
    }
}

/// The equilibrium matrix for forces: a column for each member, which holds the unit vectors along the
/// member at its ends. Of no unit, so that its rank is decided alike for small and large structures.
pub(super) fn directions(structure: &Structure) -> DMatrix<f64> {
    let mut matrix = DMatrix::zeros(3 * structure.nodes().len(), structure.members().len());
    for (column, member) in structure.members().iter().enumerate() {
        let [from, to] = structure.ends(member);
        let along = (from.position() - to.position()) / structure.length(member);
        let [start, end] = member.ends;
        for (axis, part) in along.to_array().into_iter().enumerate() {
            if let Some(entry) = matrix.get_mut((3 * start + axis, column)) {
                *entry += part;
            }
            if let Some(entry) = matrix.get_mut((3 * end + axis, column)) {
                *entry -= part;
            }
        }
    }
    matrix
}

/// The singular values and vectors, largest first.
pub(super) fn decompose(
    matrix: DMatrix<f64>,
    left: bool,
) -> Result<SVD<f64, Dyn, Dyn>, TensegrityError> {
    if matrix.is_empty() {
        return Err(TensegrityError::Undecided);
    }
    SVD::try_new(matrix, left, true, f64::EPSILON, SWEEPS).ok_or(TensegrityError::Undecided)
}

/// The number of singular values that are not zero.
pub(super) fn rank(parts: &SVD<f64, Dyn, Dyn>) -> usize {
    let values = &parts.singular_values;
    let least = values.max() * RANK_TOLERANCE;
    values.iter().filter(|&&value| value > least).count()
}

/// An orthonormal basis of the translations and rotations of the nodes: six, or fewer if all nodes are
/// on a line.
fn rigid_motions(structure: &Structure) -> Result<DMatrix<f64>, TensegrityError> {
    let nodes = structure.nodes();
    let places: Vec<DVector<f64>> = centred(structure);
    let mut motions = DMatrix::zeros(3 * nodes.len(), 6);
    for (node, place) in places.iter().enumerate() {
        for axis in 0..3 {
            let [next, last] = [(axis + 1) % 3, (axis + 2) % 3];
            let entries = [
                (3 * node + axis, axis, 1.0),
                // About the axis: the plane of the other two turns.
                (3 * node + next, 3 + axis, -part(place, last)),
                (3 * node + last, 3 + axis, part(place, next)),
            ];
            for (row, column, value) in entries {
                if let Some(entry) = motions.get_mut((row, column)) {
                    *entry = value;
                }
            }
        }
    }
    let parts = decompose(motions, true)?;
    let rank = rank(&parts);
    let left = parts.u.ok_or(TensegrityError::Undecided)?;
    Ok(left.columns(0, rank).into_owned())
}

fn part(vector: &DVector<f64>, index: usize) -> f64 {
    vector.get(index).copied().unwrap_or(0.0)
}

/// The nodes relative to their mean, in units of their largest distance from it.
pub(super) fn centred(structure: &Structure) -> Vec<DVector<f64>> {
    let nodes = structure.nodes().iter();
    let places: Vec<DVector<f64>> = nodes
        .map(|node| DVector::from_row_slice(&node.position().to_array()))
        .collect();
    let mut mean = DVector::zeros(3);
    for place in &places {
        mean += place / places.len() as f64;
    }
    let distances = places.iter().map(|place| (place - &mean).norm());
    let size = distances.fold(f64::MIN_POSITIVE, f64::max);
    places.iter().map(|place| (place - &mean) / size).collect()
}
