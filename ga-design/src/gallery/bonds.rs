//! Decides which atoms are shown joined: those about as close as their covalent radii say, by a rod
//! that has the colour of each atom on its half.

use super::GalleryError;
use crate::crystallography::{Atom, Element};
use crate::export::{Material, Scene};
use crate::mesh::{self, Mesh};
use glam::DVec3;
use std::collections::BTreeMap;

/// Two atoms are joined up to this multiple of the sum of their covalent radii, the usual allowance
/// of programs that draw molecules.
const FARTHEST: f64 = 1.15;

/// Atoms closer than this multiple share one site and are not joined.
const NEAREST: f64 = 0.5;

/// Two atoms that are both larger than this, in ångström, are metals side by side: they touch the same
/// neighbours rather than each other.
const METAL: f64 = 1.2;

/// The radius of a rod, in ångström.
const RADIUS: f64 = 0.09;

/// The pairs of atoms that are joined, as positions in the list.
pub(super) fn bonds(atoms: &[Atom]) -> Vec<[usize; 2]> {
    let mut pairs = Vec::new();
    for (i, one) in atoms.iter().enumerate() {
        for (j, other) in atoms.iter().enumerate().skip(i + 1) {
            let radii = [one, other].map(|atom| atom.element.covalent_radius());
            if radii.iter().all(|radius| *radius > METAL) {
                continue;
            }
            let sum: f64 = radii.iter().sum();
            let distance = DVec3::from(one.cart).distance(DVec3::from(other.cart));
            if (NEAREST * sum..FARTHEST * sum).contains(&distance) {
                pairs.push([i, j]);
            }
        }
    }
    pairs
}

/// Adds the rods to a scene, all of one colour as one shape.
pub(super) fn add_bonds(scene: &mut Scene, atoms: &[Atom]) -> Result<(), GalleryError> {
    let mut halves: BTreeMap<u8, (Element, Vec<Mesh>)> = BTreeMap::new();
    for pair in bonds(atoms) {
        let [Some(one), Some(other)] = pair.map(|i| atoms.get(i)) else {
            continue;
        };
        let middle = DVec3::from(one.cart).midpoint(DVec3::from(other.cart));
        for atom in [one, other] {
            let rod = mesh::cylinder(atom.cart, middle.to_array(), RADIUS, 14)?;
            let (_, rods) = halves
                .entry(atom.element.number())
                .or_insert_with(|| (atom.element, Vec::new()));
            rods.push(rod);
        }
    }
    for (element, rods) in halves.into_values() {
        let name = format!("bonds of {}", element.name().to_lowercase());
        let material = Material::new(&name, element.colour()).with_roughness(0.45)?;
        let material = scene.add_material(material);
        scene.add(&name, Mesh::joined(&rods)?, material)?;
    }
    Ok(())
}
