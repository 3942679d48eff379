//! The rotations that structures are generated with: all words in the products of two roots.

use super::TensegrityError;
use crate::crystallography::Isometry;
use ga_cga::{Motor, Rotor, Translator, Vector3};
use std::f64::consts::PI;

/// More rotations than any group has that is used here.
const MOST: usize = 480;

/// Rotors closer than this are the same; those of a group of this size are farther apart.
const SAME: f64 = 1e-6;

/// The rotations that two roots at a time generate: the groups p̄q̄ of Table 3.2.
#[derive(Debug, Clone)]
pub(crate) struct Rotations {
    /// The product ab, of order p.
    pub ab: Rotor,
    /// The product bc, of order q.
    pub bc: Rotor,
    /// The product ac, a half turn, which is ab bc.
    pub ac: Rotor,
    all: Vec<Rotor>,
}

impl Rotations {
    /// The group of the roots a = e₁, c = e₃ and b at π/p from a and π/q from c (3.6, 3.7, in closed
    /// form), turned by this rotor.
    pub fn new(p: usize, q: usize, turned: Rotor) -> Result<Self, TensegrityError> {
        let [first, third] = [p, q].map(|order| (PI / order as f64).cos());
        let square = 1.0 - first * first - third * third;
        let [a, b, c]: [Vector3; 3] = [
            [1.0, 0.0, 0.0],
            [first, square.max(0.0).sqrt(), third],
            [0.0, 0.0, 1.0],
        ]
        .map(|root| turned.apply(Vector3::from(root)));
        let [ab, bc, ac] = [a * b, b * c, a * c];
        let mut all = vec![Rotor::identity()];
        let mut next = 0;
        while let Some(&known) = all.get(next) {
            for generator in [ab, bc] {
                let word = known * generator;
                let is_known = |other: &Rotor| {
                    (word - *other).norm() < SAME || (word + *other).norm() < SAME
                };
                if !all.iter().any(is_known) {
                    all.push(word);
                }
            }
            if all.len() > MOST {
                return Err(TensegrityError::TooMany {
                    what: "rotations",
                    value: all.len(),
                    most: MOST,
                });
            }
            next += 1;
        }
        Ok(Self { ab, bc, ac, all })
    }

    /// A rotation by the same angle as this one, about an axis at right angles to a given one.
    pub fn across(&self, like: Rotor, axis: Vector3) -> Option<Rotor> {
        // The same whichever sign the rotor has.
        let half = |rotor: Rotor| (rotor.angle() / 2.0).cos().abs();
        let is_alike = |rotor: &&Rotor| {
            let across = rotor.axis().map(|other| other.scalar_product(axis));
            (half(**rotor) - half(like)).abs() < SAME && across.is_some_and(|c| c.abs() < SAME)
        };
        self.all.iter().find(is_alike).copied()
    }

    /// All of them as transformations of points.
    pub fn isometries(&self) -> Vec<Isometry> {
        self.all.iter().map(|&rotor| isometry(rotor)).collect()
    }
}

fn isometry(rotor: Rotor) -> Isometry {
    Isometry {
        mirror: None,
        motor: Motor::rigid(rotor, Translator::identity()),
    }
}

/// The rotations of the regular tetrahedron, 3̄3̄, with their half turns about the axes.
pub(crate) fn tetrahedral() -> Result<Rotations, TensegrityError> {
    Rotations::new(3, 3, eighth_turn(Vector3::new(0.0, 1.0, 0.0)))
}

/// The rotations of the cube, 4̄3̄, with their quarter turns about the axes.
pub(crate) fn octahedral() -> Result<Rotations, TensegrityError> {
    Rotations::new(4, 3, eighth_turn(Vector3::new(1.0, 0.0, 0.0)))
}

/// The rotations of the regular icosahedron, 5̄3̄, with half turns about the axes.
pub(crate) fn icosahedral() -> Result<Rotations, TensegrityError> {
    Rotations::new(5, 3, Rotor::identity())
}

/// The rotations of a regular n-gon with two sides, n̄2̄, about the z axis; one of the half turns is about
/// the y axis.
pub(crate) fn dihedral(n: usize) -> Result<Rotations, TensegrityError> {
    Rotations::new(n, 2, Rotor::identity())
}

fn eighth_turn(axis: Vector3) -> Rotor {
    Rotor::about_axis(axis, PI / 4.0).unwrap_or(Rotor::identity())
}
