//! Which of the states of self-stress is shown where there are several: one that presses every strut
//! and pulls every cable, alike in all members of a class if it can be.

use super::TensegrityError;
use super::equilibrium::{Equilibrium, decompose};
use super::structure::Structure;
use nalgebra::{DMatrix, DVector};

/// The steps after which the search for a proper state is given up.
const STEPS: usize = 4_000;

/// A force below this part of the mean force of the struts is none.
const SLACK: f64 = 1e-7;

/// Forces in members of one class that differ by less, in a state of size one, are alike.
const DIFFERING: f64 = 1e-8;

/// A state of self-stress.
#[derive(Debug, Clone)]
pub(super) struct Prestress {
    /// The force density of each member, force over length, in the order of the structure: positive in
    /// tension; the mean of the struts is −1.
    pub densities: Vec<f64>,
    /// Whether all struts are in compression and all cables in tension.
    pub is_proper: bool,
}

/// A state of self-stress of this structure; `None` if it has none.
pub(super) fn prestress(
    structure: &Structure,
    equilibrium: &Equilibrium,
) -> Result<Option<Prestress>, TensegrityError> {
    let states = &equilibrium.self_stresses;
    if states.ncols() == 0 {
        return Ok(None);
    }
    let signs: Vec<f64> = structure.members().iter().map(|m| m.role.sign()).collect();
    let signs = DVector::from_vec(signs);
    let alike = states_alike(structure, states)?;
    // First those that are alike in each class, then any.
    let spaces = [Some(alike), Some(states.clone())];
    let mut first = None;
    for space in spaces.into_iter().flatten().filter(|s| s.ncols() > 0) {
        let forces = towards_proper(&space, &signs);
        let state = scaled(structure, &forces, &signs);
        if state.is_proper {
            return Ok(Some(state));
        }
        first.get_or_insert(state);
    }
    Ok(first)
}

/// An orthonormal basis of the states that are alike in all members of each class.
fn states_alike(
    structure: &Structure,
    states: &DMatrix<f64>,
) -> Result<DMatrix<f64>, TensegrityError> {
    // The part of a state that differs within a class must vanish.
    let mut differing = states.clone();
    for mut column in differing.column_iter_mut() {
        let mut sums = vec![(0.0, 0.0); structure.classes()];
        for (member, force) in structure.members().iter().zip(column.iter()) {
            if let Some((sum, count)) = sums.get_mut(member.class) {
                *sum += force;
                *count += 1.0;
            }
        }
        for (member, force) in structure.members().iter().zip(column.iter_mut()) {
            if let Some((sum, count)) = sums.get(member.class) {
                *force -= sum / count;
            }
        }
    }
    // An orthonormal basis of which nothing differs is what is wanted already; decomposing rounding
    // error would find a rank in it.
    if differing.amax() < DIFFERING {
        return Ok(states.clone());
    }
    // States are combinations of unit vectors: one is the measure of what differs in them.
    let count = states.ncols();
    let rows = differing.nrows().max(count);
    let parts = decompose(differing.resize_vertically(rows, 0.0), false)?;
    let right = parts.v_t.ok_or(TensegrityError::Undecided)?;
    let values = parts.singular_values.iter();
    let rank = values.filter(|&&value| value > DIFFERING).count();
    Ok(states * right.rows(rank, count - rank).transpose())
}

/// The state of this space that comes nearest to pulling all cables and pressing all struts: by
/// alternating projections onto the space and onto the cone of such forces (L. G. Gubin, B. T. Polyak,
/// E. V. Raik, “The method of projections for finding the common point of convex sets”, 1967).
fn towards_proper(space: &DMatrix<f64>, signs: &DVector<f64>) -> DVector<f64> {
    let project = |forces: &DVector<f64>| space * (space.transpose() * forces);
    let mut forces = project(signs);
    for _ in 0..STEPS {
        let mut wanted = forces.clone();
        let mut is_inside = true;
        for (force, sign) in wanted.iter_mut().zip(signs.iter()) {
            if *force * sign < 0.25 {
                is_inside = false;
                *force = sign * 0.5;
            }
        }
        if is_inside {
            break;
        }
        forces = project(&wanted);
    }
    forces
}

/// The force densities of these forces, with the mean of the struts −1.
fn scaled(structure: &Structure, forces: &DVector<f64>, signs: &DVector<f64>) -> Prestress {
    let members = structure.members();
    let densities: Vec<f64> = members
        .iter()
        .zip(forces.iter())
        .map(|(member, force)| force / structure.length(member))
        .collect();
    let pressed: Vec<f64> = densities
        .iter()
        .zip(signs.iter())
        .filter(|(_, sign)| **sign < 0.0)
        .map(|(density, _)| *density)
        .collect();
    let mean = pressed.iter().sum::<f64>() / pressed.len().max(1) as f64;
    let largest = densities
        .iter()
        .fold(0.0, |so_far: f64, q| so_far.max(q.abs()));
    // Struts that bear nothing in the mean leave no measure but the largest.
    let measure = if mean.abs() > largest * SLACK {
        -mean
    } else {
        largest
    };
    let densities: Vec<f64> = densities.iter().map(|q| q / measure).collect();
    let is_proper = densities
        .iter()
        .zip(signs.iter())
        .all(|(density, sign)| density * sign > SLACK);
    Prestress {
        densities,
        is_proper,
    }
}
