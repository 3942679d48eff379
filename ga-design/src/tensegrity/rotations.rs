//! The rotation groups that structures are generated with, turned upright, and their generators.

use super::TensegrityError;
use crate::crystallography::{Bars, Isometry, PointGroup, PointSymbol};
use ga_cga::{Motor, Rotor, Translator, Vector3};
use std::f64::consts::PI;

/// Numbers closer than this are the same.
const SAME: f64 = 1e-6;

/// A point group p̄q̄ of rotations (Table 3.2).
#[derive(Debug, Clone)]
pub(super) struct Rotations {
    /// The product ab of its roots, of order p.
    pub ab: Rotor,
    /// The product bc, of order q.
    pub bc: Rotor,
    /// The product ac, a half turn, which is ab bc.
    pub ac: Rotor,
    all: Vec<Isometry>,
}

impl Rotations {
    /// The group of the roots for p and q, turned by this rotor.
    fn new(p: u32, q: u32, turned: Rotor) -> Result<Self, TensegrityError> {
        let group = PointGroup::new(PointSymbol::new(p, q, Bars::Each)?)?;
        let [a, b, c]: [Vector3; 3] = group.roots().vectors().map(|root| turned.apply(root));
        let frame = Isometry::from(Motor::rigid(turned, Translator::identity()));
        let transformations = group.transformations().iter();
        Ok(Self {
            ab: a * b,
            bc: b * c,
            ac: a * c,
            all: transformations.map(|t| t.moved_by(&frame)).collect(),
        })
    }

    /// A rotation by the same angle as this one, about an axis at right angles to a given one.
    pub fn across(&self, like: Rotor, axis: Vector3) -> Option<Rotor> {
        // The same whichever sign the rotor has.
        let half = |rotor: Rotor| (rotor.angle() / 2.0).cos().abs();
        let is_alike = |rotor: &Rotor| {
            let across = rotor.axis().map(|other| other.scalar_product(axis));
            (half(*rotor) - half(like)).abs() < SAME && across.is_some_and(|c| c.abs() < SAME)
        };
        let mut rotors = self.all.iter().filter_map(|t| t.motor.rotation());
        rotors.find(is_alike)
    }

    /// All of them.
    pub fn isometries(&self) -> &[Isometry] {
        &self.all
    }
}

/// The rotations of the regular tetrahedron, 3̄3̄, with their half turns about the axes.
pub(super) fn tetrahedral() -> Result<Rotations, TensegrityError> {
    Rotations::new(3, 3, eighth_turn(Vector3::new(0.0, 1.0, 0.0)))
}

/// The rotations of the cube, 4̄3̄, with their quarter turns about the axes.
pub(super) fn octahedral() -> Result<Rotations, TensegrityError> {
    Rotations::new(4, 3, eighth_turn(Vector3::new(1.0, 0.0, 0.0)))
}

/// The rotations of the regular icosahedron, 5̄3̄, with half turns about the axes.
pub(super) fn icosahedral() -> Result<Rotations, TensegrityError> {
    Rotations::new(5, 3, Rotor::identity())
}

/// The rotations of a regular n-gon with two sides, n̄2̄, about the z axis; one of the half turns is about
/// the y axis.
pub(super) fn dihedral(n: usize) -> Result<Rotations, TensegrityError> {
    // A number that does not fit has no roots.
    let n = u32::try_from(n).unwrap_or(u32::MAX);
    Rotations::new(n, 2, Rotor::identity())
}

fn eighth_turn(axis: Vector3) -> Rotor {
    Rotor::about_axis(axis, PI / 4.0).unwrap_or(Rotor::identity())
}
