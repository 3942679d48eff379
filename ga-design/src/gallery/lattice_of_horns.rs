//! Decides how the figures of space groups are put together: a horn in general position in every place of a
//! block of cells, and the frames of the cells.

use super::GalleryError;
use super::horn::{frame, horn};
use super::palette::solid;
use crate::crystallography::motif::add_instances;
use crate::crystallography::{
    Cell, CellRange, Coincidence, FundamentalDomain, Isometry, Operation, Pattern,
};
use crate::export::{MaterialId, Placement, Scene};
use crate::mesh::{self, Mesh};
use ga_cga::{Point, Vector3};

/// A horn repeated by a space group.
pub(super) struct Horns {
    /// The cell.
    pub(super) cell: Cell,
    /// Where the first horn stands.
    pub(super) at: Point,
    /// The horn.
    pub(super) mesh: Mesh,
    pattern: Pattern,
}

impl Horns {
    /// A horn of this size at a point (in fractions of the edges), or where there is most room, in a block
    /// of cells.
    pub(super) fn new(
        operations: &[Operation],
        cell: Cell,
        cells: CellRange,
        at: Option<[f64; 3]>,
        size: f64,
    ) -> Result<Self, GalleryError> {
        let at = match at {
            Some(at) => Point::from(Vector3::from(cell.cartesian(at))),
            None => FundamentalDomain::of(operations, &cell)?.seed(),
        };
        let [out, aside] = frame(Vector3::new(0.62, 0.25, 0.74))?;
        let mesh = horn(at, out, aside, size)?;
        let pattern = Pattern::of_group(operations, &cell, cells)?.gathered(at);
        Ok(Self {
            cell,
            at,
            mesh,
            pattern,
        })
    }

    /// Where the horns are carried to.
    pub(super) fn places(&self) -> Result<Vec<Isometry>, GalleryError> {
        let copies = self.pattern.distinct(&self.at, &Coincidence::default())?;
        Ok(copies.into_iter().map(|copy| copy.isometry).collect())
    }

    /// Adds the horns in these places, moved by a step.
    pub(super) fn draw(
        &self,
        scene: &mut Scene,
        name: &str,
        materials: [MaterialId; 2],
        places: &[Isometry],
        origin: Vector3,
    ) -> Result<(), GalleryError> {
        let step = Isometry::translation(origin);
        let places = places.iter().map(|place| step.after(place));
        Ok(add_instances(scene, name, &self.mesh, materials, places)?)
    }
}

/// Adds the frames of a block of cells with its first corner moved by a step.
pub(super) fn frames(
    scene: &mut Scene,
    cell: &Cell,
    cells: CellRange,
    origin: Vector3,
) -> Result<(), GalleryError> {
    let bar = 0.005 * cell.volume().cbrt();
    let edges = mesh::box_edges([0.0; 3], cell.edge_vectors(), bar, 10)?;
    let shape = scene.add_shape("cell", edges);
    let grey = scene.add_material(solid("cell", [150, 157, 168])?);
    for offset in cells.offsets() {
        let at = origin + Vector3::from(cell.cartesian(offset.map(f64::from)));
        scene.add_node("cell", shape, grey, Placement::at(at.to_array())?)?;
    }
    Ok(())
}
