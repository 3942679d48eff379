//! How a group finds the form: with one node for each rotation, balance is one equation for the first
//! node, and the force density of the struts is an eigenvalue.
//!
//! R. Connelly and M. Terrell, “Globally rigid symmetric tensegrities”, *Structural Topology* 21 (1995)
//! 59–78; R. Connelly and A. Back, “Mathematics and tensegrity”, *American Scientist* 86 (1998) 142–151.

use super::TensegrityError;
use ga_cga::{Point, Rotor, Vector3};
use nalgebra::{Matrix3, SymmetricEigen};

/// Which rotations the node at the identity is joined to: two kinds of cables and one of struts.
#[derive(Debug, Clone, Copy)]
pub(super) struct Pattern {
    /// The rotations that the cables lead to; those to their reverses come with them.
    pub cables: [Rotor; 2],
    /// The rotation that the strut leads to.
    pub strut: Rotor,
}

/// A place for the first node in which the forces on it cancel.
#[derive(Debug, Clone, Copy)]
pub(super) struct Balance {
    /// The place, with the strut of length one.
    pub node: Point,
    /// The lengths of the two kinds of cables.
    pub cables: [f64; 2],
}

/// The ranges of the ratio of the cables' force densities that are searched.
const DENSITIES: f64 = 1e4;

/// The halvings of that range, as logarithms, until neighbouring numbers are reached.
const HALVINGS: usize = 80;

impl Pattern {
    /// The place of the first node for these force densities of the cables: with struts of force
    /// density −σ, the force on a node p is (C − σS) p, and σ is the least for which it vanishes. Up to
    /// there C − σS is positive semidefinite, as super-stability needs.
    pub fn balance(&self, densities: [f64; 2]) -> Option<Balance> {
        let [first, second] = self.cables.map(difference);
        let cables = first * densities[0] + second * densities[1];
        let lower = cables.cholesky()?.l().try_inverse()?;
        let pushed = lower * difference(self.strut) * lower.transpose();
        let eigen = SymmetricEigen::try_new(pushed, f64::EPSILON, 1000)?;
        let largest = eigen.eigenvalues.imax();
        let place = lower.transpose() * eigen.eigenvectors.column(largest);
        let place = Vector3::from([place.x, place.y, place.z]);
        let moved = |rotor: Rotor| (rotor.apply(place) - place).norm();
        let strut = moved(self.strut);
        // Written so that a NaN fails it too.
        let has_length = strut > 1e-9 * place.norm();
        has_length.then(|| Balance {
            node: Point::from(place / strut),
            cables: self.cables.map(|cable| moved(cable) / strut),
        })
    }

    /// The balance in which the second kind of cables is this many times as long as the first: the
    /// ratio of their force densities is moved until it is.
    pub fn with_ratio(&self, ratio: f64) -> Result<Balance, TensegrityError> {
        let none = TensegrityError::NoSelfStress {
            what: "no force densities make cables of this ratio of lengths",
        };
        let at = |logarithm: f64| self.balance([1.0, logarithm.exp()]);
        let is_long = |balance: &Balance| balance.cables[1] > ratio * balance.cables[0];
        // The denser the force, the shorter the cable.
        let [mut low, mut high] = [-DENSITIES.ln(), DENSITIES.ln()];
        let ends = [low, high].map(|end| at(end).as_ref().map(is_long));
        if ends != [Some(true), Some(false)] {
            return Err(none);
        }
        for _ in 0..HALVINGS {
            let middle = low.midpoint(high);
            match at(middle) {
                Some(balance) if is_long(&balance) => low = middle,
                Some(_) => high = middle,
                None => return Err(none),
            }
        }
        let balance = at(high).ok_or(none)?;
        // Where the ratio jumps over the one asked for, none has it.
        let found = balance.cables[1] / balance.cables[0];
        if (found - ratio).abs() <= 1e-9 * ratio {
            Ok(balance)
        } else {
            Err(none)
        }
    }
}

/// What the members to this rotation and its reverse contribute to the force on the first node, per
/// force density: p − R[p] for each of them, which is one only if it is a half turn.
fn difference(rotor: Rotor) -> Matrix3<f64> {
    let columns = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
        .map(|axis| nalgebra::Vector3::from(rotor.apply(Vector3::from(axis)).to_array()));
    let turned = Matrix3::from_columns(&columns);
    let one = Matrix3::identity() - turned;
    let is_half_turn = (turned - turned.transpose()).amax() < 1e-9;
    if is_half_turn {
        one
    } else {
        one + one.transpose()
    }
}
