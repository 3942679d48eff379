//! How a crystal is shown: atoms as spheres, the cell as a frame of thin bars.

use std::collections::BTreeMap;

use super::{Atom, Cell, CellRange, Element};
use crate::export::{ExportError, Material, Placement, Scene};
use crate::mesh;

/// The radius of an atom's sphere over its covalent radius: large enough to tell the elements
/// apart, small enough to see between them and for rods that join them to show.
const RADIUS_SCALE: f64 = 0.5;

/// The radius of the bars of the cell over the cube root of its volume.
const BAR_SCALE: f64 = 0.006;

/// The scene of these atoms in a block of cells, in ångström, z up.
///
/// Each atom is a node of its own, named by its label, that places the shared shape `sphere`.
///
/// # Errors
/// [`ExportError`] if there are no atoms or a position cannot be written.
pub fn scene(
    name: &str,
    title: &str,
    caption: &str,
    cell: &Cell,
    range: CellRange,
    atoms: &[Atom],
) -> Result<Scene, ExportError> {
    let mut scene = Scene::new(name, title, caption);
    let sphere = scene.add_shape("sphere", mesh::icosphere(sphere_detail(atoms.len()))?);
    let mut materials = BTreeMap::new();
    for atom in atoms {
        let element: Element = atom.element;
        let material = match materials.get(&element.number()) {
            Some(material) => *material,
            None => {
                let material =
                    Material::new(element.name(), element.colour()).with_roughness(0.35)?;
                let id = scene.add_material(material);
                materials.insert(element.number(), id);
                id
            }
        };
        let radius = RADIUS_SCALE * element.covalent_radius();
        let placement = Placement::at(atom.cart)?.scaled([radius; 3])?;
        scene.add_node(atom.label.as_ref(), sphere, material, placement)?;
    }
    let bar = BAR_SCALE * cell.volume().cbrt();
    let grey = scene.add_material(Material::new("cell", [110, 116, 128]).with_roughness(0.6)?);
    let frame = mesh::box_edges([0.0; 3], cell.edge_vectors(), bar, 12)?;
    let frame = scene.add_shape("cell", frame);
    for offset in range.offsets() {
        let origin = cell.cartesian(offset.map(f64::from));
        scene.add_node("cell", frame, grey, Placement::at(origin)?)?;
    }
    Ok(scene)
}

/// The subdivisions of the sphere: fewer where there are many.
fn sphere_detail(atoms: usize) -> usize {
    match atoms {
        0..=2_000 => 3,
        2_001..=50_000 => 2,
        _ => 1,
    }
}
