//! Decides what is told about a structure: its states of self-stress, its mechanisms, how firmly it
//! stands.

use super::TensegrityError;
use super::equilibrium::Equilibrium;
use super::prestress::prestress;
use super::stability::{Stability, verdict};
use super::structure::Structure;

/// What the statics of a structure are.
///
/// ```
/// use ga_design::tensegrity::{Analysis, Octahedron, Stability};
///
/// let structure = Octahedron::default().structure()?;
/// let analysis = Analysis::of(&structure)?;
/// assert_eq!((analysis.states, analysis.mechanisms), (1, 1));
/// assert_eq!(analysis.stability, Stability::SuperStable);
/// # Ok::<(), ga_design::tensegrity::TensegrityError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Analysis {
    /// The number of independent states of self-stress.
    pub states: usize,
    /// The number of independent infinitesimal mechanisms: displacements that lengthen no member and
    /// are no rigid motion.
    pub mechanisms: usize,
    /// The force density of each member, force over length, in the order of
    /// [`Structure::members`]: positive in tension, and −1 in the mean of the struts. Empty if there is
    /// no state of self-stress; of several a proper one, alike in all members of a class if it can be.
    pub force_densities: Vec<f64>,
    /// Whether these press every strut and pull every cable.
    pub is_proper: bool,
    /// How firmly the structure stands under them.
    pub stability: Stability,
    /// The eigenvalues of the stress matrix, in increasing order; empty without a self-stress.
    pub eigenvalues: Vec<f64>,
    /// How many of these are zero: 4 at least, for the affine motions of space.
    pub nullity: usize,
}

impl Analysis {
    /// Analyses a structure: the rank of its equilibrium matrix by singular values, its stress matrix
    /// by eigenvalues.
    ///
    /// # Errors
    /// [`TensegrityError::Undecided`] if a decomposition does not converge.
    pub fn of(structure: &Structure) -> Result<Self, TensegrityError> {
        let equilibrium = Equilibrium::of(structure)?;
        let mut analysis = Self {
            states: equilibrium.self_stresses.ncols(),
            mechanisms: equilibrium.mechanisms(),
            force_densities: Vec::new(),
            is_proper: false,
            stability: Stability::Unstressed,
            eigenvalues: Vec::new(),
            nullity: 0,
        };
        if let Some(prestress) = prestress(structure, &equilibrium)? {
            let verdict = verdict(structure, &equilibrium, &prestress)?;
            analysis.stability = verdict.stability;
            analysis.eigenvalues = verdict.eigenvalues;
            analysis.nullity = verdict.nullity;
            analysis.is_proper = prestress.is_proper;
            analysis.force_densities = prestress.densities;
        }
        Ok(analysis)
    }

    /// The largest sum of forces at a node, over the largest force: rounding error, if there is a
    /// self-stress; zero without one.
    #[must_use]
    pub fn residual(&self, structure: &Structure) -> f64 {
        let mut sums = vec![ga_cga::Vector3::new(0.0, 0.0, 0.0); structure.nodes().len()];
        let mut largest = f64::MIN_POSITIVE;
        for (member, density) in structure.members().iter().zip(&self.force_densities) {
            let [from, to] = structure.ends(member);
            let pull = (to.position() - from.position()) * *density;
            largest = largest.max(pull.norm());
            for (end, sign) in member.ends.into_iter().zip([1.0, -1.0]) {
                if let Some(sum) = sums.get_mut(end) {
                    *sum += pull * sign;
                }
            }
        }
        let worst = sums.iter().map(|sum| sum.norm()).fold(0.0, f64::max);
        worst / largest
    }
}
