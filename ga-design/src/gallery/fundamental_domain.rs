//! A cell put together of one piece: the fundamental domain of P 4₃32 and its 24 images, which fill space
//! without overlap, each shrunk a little so that all are seen.

use super::GalleryError;
use super::lattice_of_horns::frames;
use super::palette::{course, solid};
use crate::crystallography::motif::add_instances;
use crate::crystallography::{
    Cell, CellRange, Coincidence, FundamentalDomain, Pattern, SpaceGroup,
};
use crate::export::{Scene, View};
use crate::mesh::Mesh;
use ga_cga::{Point, Vector3};

/// The size of a piece in the picture over its true size.
const SHRUNK: f64 = 0.84;

/// The space group and the edge of its cell.
const NUMBER: u32 = 212;
const EDGE: f64 = 6.0;

pub(super) fn scene() -> Result<Scene, GalleryError> {
    let mut scene = Scene::new(
        "fundamental-domain",
        "One piece fills space",
        "The fundamental domain of P 4₃32: all points nearer to one point than to any of its images, cut \
         out by the dual planes q − p that lie between it and them. Its 24 images, coloured by height, \
         fill a cell and with the lattice all of space; each is drawn a little smaller than it is.",
    );
    let (domain, pattern) = pieces()?;
    let mesh = shrunk(&domain)?;
    let copies = pattern.distinct(&domain.seed(), &Coincidence::default())?;
    for copy in copies {
        let part = copy.shape.position().e3 / EDGE;
        let material = scene.add_material(solid("piece", course(part))?);
        add_instances(&mut scene, "piece", &mesh, [material; 2], [copy.isometry])?;
    }
    let cell = Cell::new([EDGE; 3], [90.0; 3])?;
    frames(&mut scene, &cell, CellRange::UNIT, Vector3::default())?;
    scene.set_view(View {
        azimuth: -1.1,
        elevation: 0.34,
    })?;
    Ok(scene)
}

/// The domain, and the pattern that carries its middle into one cell.
fn pieces() -> Result<(FundamentalDomain, Pattern), GalleryError> {
    let missing = GalleryError::Degenerate {
        what: "a space group of the figure",
    };
    let operations = SpaceGroup::standard(NUMBER)
        .ok_or(missing)?
        .generate_operations()?;
    let cell = Cell::new([EDGE; 3], [90.0; 3])?;
    let domain = FundamentalDomain::of(&operations, &cell)?;
    let pattern = Pattern::of_group(&operations, &cell, CellRange::UNIT)?;
    let pattern = pattern.gathered(domain.seed());
    Ok((domain, pattern))
}

/// The domain drawn together towards its seed.
fn shrunk(domain: &FundamentalDomain) -> Result<Mesh, GalleryError> {
    let mesh = domain.mesh()?;
    let seed: Point = domain.seed();
    let positions = mesh.positions().iter().map(|corner| {
        let from = Vector3::from(*corner) - seed.position();
        (seed.position() + from * SHRUNK).to_array()
    });
    Ok(Mesh::new(
        positions.collect(),
        mesh.normals().to_vec(),
        mesh.triangles().to_vec(),
    )?)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_pieces_have_the_volume_of_the_cell_together() -> Result<(), GalleryError> {
        let (domain, pattern) = pieces()?;
        assert_eq!(pattern.count(), 24);
        assert!((24.0 * domain.volume() - EDGE.powi(3)).abs() < 1e-9);
        // Moved by its isometry a piece has its seed where the copy is, deep inside.
        for copy in pattern.distinct(&domain.seed(), &Coincidence::default())? {
            let home = copy.isometry.inverse().apply(copy.shape);
            assert!(domain.depth(home) > 0.3);
        }
        Ok(())
    }
}
