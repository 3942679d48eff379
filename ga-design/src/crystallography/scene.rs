//! How a crystal is shown: atoms as spheres, bonds as rods of two colours, the cell as a frame of
//! thin bars.

use std::collections::{BTreeMap, HashMap};

use glam::DVec3;

use super::bonds::Bond;
use super::{Atom, Cell, CellRange, Element};
use crate::export::{ExportError, Material, MaterialId, Placement, Scene, ShapeId};
use crate::mesh;

/// The radius of an atom's sphere over its covalent radius: large enough to tell the elements
/// apart, small enough to see between them and for rods that join them to show.
const RADIUS_SCALE: f64 = 0.5;

/// The radius of the bars of the cell over the cube root of its volume.
const BAR_SCALE: f64 = 0.006;

/// The radius of the rod of a bond, in ångström.
const ROD_RADIUS: f64 = 0.09;

/// Up to so many atoms each is a node of its own; more are instances, one set for each element.
///
/// Programs that open a scene of some ten thousand nodes with ease take minutes for a hundred
/// thousand, and instances with less effort than either; but a node has the name of its atom.
pub const MOST_NODES: usize = 20_000;

/// Atoms closer than this, in ångström, share a site.
const SHARED: f64 = 0.1;

/// The scene of these atoms in a block of cells, in ångström, z up.
///
/// Up to [`MOST_NODES`] atoms each is a node of its own, named by its label, that places the shared
/// shape `sphere`; where atoms share a site the most frequent has the largest. More are placed as instances of it, one set for each element, named by the
/// element; so are the frames of more than [`MOST_NODES`] cells.
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
    let mut materials = Materials::default();
    let mut placed = Placer::new(atoms.len());
    let radius = |atom: &Atom| RADIUS_SCALE * atom.element.covalent_radius();
    for (atom, instead) in atoms.iter().zip(more_frequent(atoms)) {
        let element: Element = atom.element;
        let material = materials.of(element, &mut scene, |element| {
            Material::new(element.name(), element.colour()).with_roughness(0.35)
        })?;
        // Of atoms that share a site the most frequent is seen: the others are inside it.
        let outer = instead.and_then(|at| atoms.get(at)).map(radius);
        let size = radius(atom).min(outer.map_or(f64::INFINITY, |outer| 0.9 * outer));
        let placement = Placement::at(atom.cart)?.scaled([size; 3])?;
        placed.place(
            &mut scene,
            atom.label.as_ref(),
            (sphere, material),
            placement,
        )?;
    }
    placed.finish(&mut scene, Element::name, &materials)?;
    add_frames(&mut scene, cell, range)?;
    Ok(scene)
}

/// Adds the bonds among atoms to their scene: rods of the shape `rod`, each half in the colour of
/// its atom, as nodes named `bond`; more than [`MOST_NODES`] as instances.
///
/// Bonds that lead out of the list ([`Bond::image`] not zero) are not shown. Of atoms that share a
/// site only the one that is there most often has rods.
///
/// # Errors
/// [`ExportError`] if a position cannot be written.
pub fn add_bonds(scene: &mut Scene, atoms: &[Atom], bonds: &[Bond]) -> Result<(), ExportError> {
    let instead = more_frequent(atoms);
    let is_shown = |at: &usize| instead.get(*at).is_some_and(Option::is_none);
    let shown: Vec<_> = bonds
        .iter()
        .filter(|bond| bond.image == [0; 3] && bond.atoms.iter().all(is_shown))
        .filter_map(|bond| {
            let [one, other] = bond.atoms.map(|at| atoms.get(at));
            Some([one?, other?])
        })
        .collect();
    if shown.is_empty() {
        return Ok(());
    }
    let rod = mesh::cylinder([0.0; 3], [0.0, 0.0, 1.0], 1.0, rod_detail(shown.len()))?;
    let rod = scene.add_shape("rod", rod);
    let mut materials = Materials::default();
    let mut placed = Placer::new(2 * shown.len());
    for [one, other] in shown {
        for [near, far] in [[one, other], [other, one]] {
            let material = materials.of(near.element, scene, |element| {
                let name = format!("bonds of {}", element.name().to_lowercase());
                Material::new(name, element.colour()).with_roughness(0.45)
            })?;
            let placement = half_rod(near.cart, far.cart)?;
            placed.place(scene, "bond", (rod, material), placement)?;
        }
    }
    placed.finish(scene, |_| "bonds", &materials)
}

/// The unit rod along z, placed from an atom halfway to another.
fn half_rod(from: [f64; 3], to: [f64; 3]) -> Result<Placement, ExportError> {
    let step = DVec3::from(to) - DVec3::from(from);
    let length = step.length();
    let along = step / length;
    // The rotation from z to the direction of the bond; opposite to z, half a turn about x.
    let turn = if along.z > -1.0 + 1e-12 {
        [1.0 + along.z, -along.y, along.x, 0.0]
    } else {
        [0.0, 1.0, 0.0, 0.0]
    };
    Placement::at(from)?
        .rotated(turn)?
        .scaled([ROD_RADIUS, ROD_RADIUS, 0.5 * length])
}

/// For each atom the one that shares its site and is there more often, if there is one; of equals the
/// first counts as the more frequent.
#[must_use]
pub fn more_frequent(atoms: &[Atom]) -> Vec<Option<usize>> {
    let bin = |atom: &Atom| atom.cart.map(|value| (value / SHARED).round() as i64);
    let mut bins: HashMap<[i64; 3], Vec<usize>> = HashMap::new();
    let shared = |atom: &Atom| atom.occupancy < 1.0;
    for (at, atom) in atoms.iter().enumerate().filter(|(_, atom)| shared(atom)) {
        bins.entry(bin(atom)).or_default().push(at);
    }
    let find = |(at, atom): (usize, &Atom)| {
        if !shared(atom) {
            return None;
        }
        let [x, y, z] = bin(atom);
        let around = (-1..=1)
            .flat_map(|i| (-1..=1).flat_map(move |j| (-1..=1).map(move |k| [x + i, y + j, z + k])));
        let others = around.filter_map(|bin| bins.get(&bin)).flatten().copied();
        let near = others.filter_map(|other| {
            let rival = atoms.get(other)?;
            let distance = DVec3::from(rival.cart).distance(DVec3::from(atom.cart));
            (distance < SHARED).then_some((other, rival.occupancy))
        });
        // The atom itself is among them.
        let first = near.reduce(|best, next| {
            let is_more = next.1 > best.1 || (next.1 == best.1 && next.0 < best.0);
            if is_more { next } else { best }
        });
        first.map(|(best, _)| best).filter(|best| *best != at)
    };
    atoms.iter().enumerate().map(find).collect()
}

fn add_frames(scene: &mut Scene, cell: &Cell, range: CellRange) -> Result<(), ExportError> {
    let bar = BAR_SCALE * cell.volume().cbrt();
    let grey = scene.add_material(Material::new("cell", [110, 116, 128]).with_roughness(0.6)?);
    let frame = mesh::box_edges([0.0; 3], cell.edge_vectors(), bar, 12)?;
    let frame = scene.add_shape("cell", frame);
    let origins = range
        .offsets()
        .map(|offset| Placement::at(cell.cartesian(offset.map(f64::from))));
    if range.count() > MOST_NODES as u64 {
        let origins = origins.collect::<Result<Vec<_>, _>>()?;
        return scene.add_instances("cell", frame, grey, origins);
    }
    for origin in origins {
        scene.add_node("cell", frame, grey, origin?)?;
    }
    Ok(())
}

/// One material for each element that was asked for.
#[derive(Default)]
struct Materials(BTreeMap<Element, MaterialId>);

impl Materials {
    fn of(
        &mut self,
        element: Element,
        scene: &mut Scene,
        make: impl Fn(Element) -> Result<Material, ExportError>,
    ) -> Result<MaterialId, ExportError> {
        if let Some(material) = self.0.get(&element) {
            return Ok(*material);
        }
        let material = scene.add_material(make(element)?);
        self.0.insert(element, material);
        Ok(material)
    }
}

/// Places things as nodes, or gathers them as instances where there are too many.
struct Placer {
    gathers: bool,
    gathered: BTreeMap<(ShapeId, MaterialId), Vec<Placement>>,
}

impl Placer {
    fn new(count: usize) -> Self {
        Self {
            gathers: count > MOST_NODES,
            gathered: BTreeMap::new(),
        }
    }

    fn place(
        &mut self,
        scene: &mut Scene,
        name: &str,
        (shape, material): (ShapeId, MaterialId),
        placement: Placement,
    ) -> Result<(), ExportError> {
        if self.gathers {
            let same = self.gathered.entry((shape, material)).or_default();
            same.push(placement);
            return Ok(());
        }
        scene.add_node(name, shape, material, placement)
    }

    /// Adds what was gathered, named by element.
    fn finish(
        self,
        scene: &mut Scene,
        name: impl Fn(Element) -> &'static str,
        materials: &Materials,
    ) -> Result<(), ExportError> {
        for ((shape, material), placements) in self.gathered {
            let element = materials.0.iter().find(|(_, known)| **known == material);
            let name = element.map_or("", |(element, _)| name(*element));
            scene.add_instances(name, shape, material, placements)?;
        }
        Ok(())
    }
}

/// The subdivisions of the sphere: fewer where there are many.
fn sphere_detail(atoms: usize) -> usize {
    match atoms {
        0..=2_000 => 3,
        2_001..=50_000 => 2,
        _ => 1,
    }
}

/// The sides of a rod: fewer where there are many.
fn rod_detail(bonds: usize) -> usize {
    match bonds {
        0..=4_000 => 14,
        _ => 6,
    }
}
