//! How firmly a prestress holds a structure: by the eigenvalues of the stress matrix.
//!
//! R. Connelly, “Rigidity and energy”, *Invent. Math.* 66 (1982) 11–33; J. Y. Zhang and M. Ohsaki,
//! “Stability conditions for tensegrity structures”, *Int. J. Solids Structures* 44 (2007) 3875–3886.

use super::TensegrityError;
use super::equilibrium::{Equilibrium, RANK_TOLERANCE, decompose, rank};
use super::prestress::Prestress;
use super::structure::Structure;
use nalgebra::DMatrix;

/// Eigenvalues below this part of the largest are zero.
const ZERO: f64 = 1e-8;

/// How firmly a structure stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Stability {
    /// There is no state of self-stress: nothing can be tightened.
    Unstressed,
    /// There are states of self-stress, but none was found that pulls every cable and presses every
    /// strut.
    Slack,
    /// Some displacement without lengthening sets energy free: the structure gives way.
    Unstable,
    /// Some displacement neither costs energy nor sets it free, to second order.
    Undecided,
    /// Every displacement without lengthening costs energy: the structure is stiff if it is prestressed
    /// no more than its material can bear.
    PrestressStable,
    /// No other placement of the nodes with cables no longer and struts no shorter exists, in any
    /// space: the structure is stable at every level of prestress, of whatever material.
    SuperStable,
}

impl Stability {
    /// The name in words.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Stability::Unstressed => "unstressed",
            Stability::Slack => "slack",
            Stability::Unstable => "unstable",
            Stability::Undecided => "undecided",
            Stability::PrestressStable => "prestress stable",
            Stability::SuperStable => "super-stable",
        }
    }
}

/// What the stress matrix of a prestress says.
#[derive(Debug, Clone)]
pub(super) struct Verdict {
    pub stability: Stability,
    /// The eigenvalues of the stress matrix, in increasing order.
    pub eigenvalues: Vec<f64>,
    /// How many of them are zero.
    pub nullity: usize,
}

/// Decides how firmly a structure stands under a prestress.
pub(super) fn verdict(
    structure: &Structure,
    equilibrium: &Equilibrium,
    prestress: &Prestress,
) -> Result<Verdict, TensegrityError> {
    let stress = stress_matrix(structure, &prestress.densities);
    let mut eigenvalues: Vec<f64> = stress.symmetric_eigenvalues().iter().copied().collect();
    eigenvalues.sort_by(f64::total_cmp);
    let largest = eigenvalues
        .iter()
        .fold(0.0, |so_far: f64, e| so_far.max(e.abs()));
    let nullity = eigenvalues
        .iter()
        .filter(|e| e.abs() <= ZERO * largest)
        .count();
    let is_semidefinite = eigenvalues.iter().all(|e| *e >= -ZERO * largest);
    let stability = if !prestress.is_proper {
        Stability::Slack
    } else if is_semidefinite && nullity == 4 && spans_quadrics(structure)? {
        Stability::SuperStable
    } else {
        on_mechanisms(&stress, equilibrium, largest)
    };
    Ok(Verdict {
        stability,
        eigenvalues,
        nullity,
    })
}

/// The stress matrix: the Laplacian of the structure with the force densities as weights.
fn stress_matrix(structure: &Structure, densities: &[f64]) -> DMatrix<f64> {
    let nodes = structure.nodes().len();
    let mut stress = DMatrix::zeros(nodes, nodes);
    for (member, density) in structure.members().iter().zip(densities) {
        let [from, to] = member.ends;
        for (row, column, value) in [
            (from, from, *density),
            (to, to, *density),
            (from, to, -density),
            (to, from, -density),
        ] {
            if let Some(entry) = stress.get_mut((row, column)) {
                *entry += value;
            }
        }
    }
    stress
}

/// Whether no affine deformation keeps all lengths: the directions of the members lie on no cone of
/// second degree, which six independent products of coordinates tell.
fn spans_quadrics(structure: &Structure) -> Result<bool, TensegrityError> {
    let members = structure.members();
    let mut products = DMatrix::zeros(members.len().max(6), 6);
    for (row, member) in members.iter().enumerate() {
        let [from, to] = structure.ends(member);
        let along = (from.position() - to.position()) / structure.length(member);
        let [x, y, z] = along.to_array();
        for (column, value) in [x * x, y * y, z * z, x * y, y * z, z * x]
            .into_iter()
            .enumerate()
        {
            if let Some(entry) = products.get_mut((row, column)) {
                *entry = value;
            }
        }
    }
    let parts = decompose(products, false)?;
    Ok(rank(&parts) == 6)
}

/// Decides by the energy of those displacements that lengthen no member and are no rigid motion.
fn on_mechanisms(stress: &DMatrix<f64>, equilibrium: &Equilibrium, largest: f64) -> Stability {
    let freedoms = equilibrium.rigid.nrows();
    let identity = DMatrix::<f64>::identity(freedoms, freedoms);
    // What is neither a mechanism nor orthogonal to all of them: made stiff, so that it decides nothing.
    let others = &equilibrium.lengthening * equilibrium.lengthening.transpose()
        + &equilibrium.rigid * equilibrium.rigid.transpose();
    let mechanisms = &identity - &others;
    let energy = stress.kronecker(&DMatrix::<f64>::identity(3, 3));
    let energy = &mechanisms * energy * &mechanisms + others * largest;
    let shift = identity * (largest * 10.0 * RANK_TOLERANCE.max(ZERO));
    if (&energy - &shift).cholesky().is_some() {
        Stability::PrestressStable
    } else if (energy + shift).cholesky().is_some() {
        Stability::Undecided
    } else {
        Stability::Unstable
    }
}
