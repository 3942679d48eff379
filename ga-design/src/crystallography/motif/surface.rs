//! How a mesh is a motif: vertices moved as points, normals as free vectors, triangles turned round by
//! reflections so that outside stays outside.

use ga_cga::{DirectionVector, Point, Vector3};

use super::bins::Bins;
use super::points::middle;
use super::{Coincidence, Fingerprint, Motif, MotifError};
use crate::crystallography::Isometry;
use crate::mesh::{Mesh, MeshError};

/// The image of a mesh under an isometry.
pub(super) fn image(mesh: &Mesh, by: &Isometry) -> Result<Mesh, MeshError> {
    let normal = |[x, y, z]: &[f64; 3]| {
        let free = DirectionVector::along(Vector3::new(*x, *y, *z));
        by.apply(free).vector().to_array()
    };
    let position = |p: &[f64; 3]| by.apply(at(*p)).position().to_array();
    let triangle = |[a, b, c]: &[u32; 3]| match by.mirror {
        Some(_) => [*a, *c, *b],
        None => [*a, *b, *c],
    };
    Mesh::new(
        mesh.positions().iter().map(position).collect(),
        mesh.normals().iter().map(normal).collect(),
        mesh.triangles().iter().map(triangle).collect(),
    )
}

impl Motif for Mesh {
    fn moved(&self, by: &Isometry) -> Result<Self, MotifError> {
        Ok(image(self, by)?)
    }

    /// Meshes coincide if every vertex of each is one of the other; which of them triangles join is not
    /// compared.
    fn coincides(&self, other: &Self, when: &Coincidence) -> bool {
        covers(self, other, when) && covers(other, self, when)
    }

    fn fingerprint(&self, when: &Coincidence) -> Fingerprint {
        let points: Vec<_> = self.positions().iter().copied().map(at).collect();
        middle(&points, when)
    }
}

fn at([x, y, z]: [f64; 3]) -> Point {
    Point::at(x, y, z)
}

/// Whether every vertex of the second mesh is near one of the first.
fn covers(first: &Mesh, second: &Mesh, when: &Coincidence) -> bool {
    let print = |values: &[f64; 3]| Fingerprint {
        values: *values,
        tolerance: when.distance,
    };
    let prints: Vec<_> = first.positions().iter().map(print).collect();
    let Some(mut bins) = Bins::for_prints(&prints) else {
        return false;
    };
    for (index, position) in first.positions().iter().enumerate() {
        bins.insert(*position, index);
    }
    second.positions().iter().all(|position| {
        let here = at(*position);
        let near = bins.near(*position);
        let mut known = near
            .iter()
            .filter_map(|&index| first.positions().get(index));
        known.any(|other| at(*other).distance(here) <= when.distance)
    })
}
