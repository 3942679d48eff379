//! Decides how a scene is spelled out for formats that cannot share shapes: every node's own vertices.

use super::{ExportError, Format, Line, Material, Scene, Shape};
use crate::mesh::Mesh;

/// The most triangles that are spelled out: half a gigabyte of them in the tightest format. Only GLB
/// stores a shape once however often it is placed.
pub const MOST_TRIANGLES: usize = 10_000_000;

/// A surface of the scene with its vertices where they stand.
#[derive(Debug, Clone)]
pub struct PlacedSurface<'a> {
    /// The node's name.
    pub name: &'a str,
    /// The node's material.
    pub material: &'a Material,
    /// The vertices in scene coordinates.
    pub positions: Vec<[f64; 3]>,
    /// The unit normals in scene coordinates.
    pub normals: Vec<[f64; 3]>,
    /// The triangles, as positions in this surface's own list of vertices.
    pub triangles: &'a [[u32; 3]],
}

/// A line of the scene with its points where they stand.
#[derive(Debug, Clone)]
pub struct PlacedLine<'a> {
    /// The node's name.
    pub name: &'a str,
    /// The node's material.
    pub material: &'a Material,
    /// The points in scene coordinates.
    pub points: Vec<[f64; 3]>,
    /// Whether the last point is joined to the first.
    pub closed: bool,
}

/// The surfaces of a scene, one by one, in the order of its nodes.
pub fn surfaces(scene: &Scene) -> impl Iterator<Item = PlacedSurface<'_>> {
    scene.placed().filter_map(|(node, shape, material)| {
        let mesh: &Mesh = match shape {
            Shape::Surface(mesh) => mesh,
            Shape::Line(_) => return None,
        };
        let place = node.placement;
        Some(PlacedSurface {
            name: node.name,
            material,
            positions: mesh.positions().iter().map(|&p| place.apply(p)).collect(),
            normals: mesh
                .normals()
                .iter()
                .map(|&n| place.apply_normal(n))
                .collect(),
            triangles: mesh.triangles(),
        })
    })
}

/// The lines of a scene, one by one, in the order of its nodes.
pub fn lines(scene: &Scene) -> impl Iterator<Item = PlacedLine<'_>> {
    scene.placed().filter_map(|(node, shape, material)| {
        let line: &Line = match shape {
            Shape::Surface(_) => return None,
            Shape::Line(line) => line,
        };
        Some(PlacedLine {
            name: node.name,
            material,
            points: line
                .points()
                .iter()
                .map(|&p| node.placement.apply(p))
                .collect(),
            closed: line.is_closed(),
        })
    })
}

/// The number of vertices and of triangles of all surfaces, if there are at most [`MOST_TRIANGLES`].
fn totals(scene: &Scene, format: Format) -> Result<[usize; 2], ExportError> {
    scene.check_not_empty()?;
    let mut totals = [0_usize; 2];
    for (_, shape, _) in scene.placed() {
        if let Shape::Surface(mesh) = shape {
            totals[0] = totals[0].saturating_add(mesh.positions().len());
            totals[1] = totals[1].saturating_add(mesh.triangles().len());
        }
    }
    if totals[1] > MOST_TRIANGLES {
        return Err(ExportError::TooLarge {
            format,
            what: "more than ten million triangles; only .glb stores a shape once and places it \
                   often",
        });
    }
    Ok(totals)
}

/// An error where drawing all surfaces would take more memory than a computer has.
pub(super) fn check_drawable(scene: &Scene, format: Format) -> Result<(), ExportError> {
    totals(scene, format).map(drop)
}

/// The number of vertices and of triangles of all surfaces, if the format can count them and there
/// is at least one.
pub(super) fn counts(scene: &Scene, format: Format) -> Result<[u32; 2], ExportError> {
    let totals = totals(scene, format)?;
    if totals[1] == 0 {
        return Err(ExportError::NothingToHold {
            scene: scene.title().to_owned(),
            format,
            needed: "surfaces",
        });
    }
    // Vertex numbers are read as signed 32-bit integers by many programs.
    match totals.map(i32::try_from) {
        [Ok(vertices), Ok(triangles)] => Ok([vertices.unsigned_abs(), triangles.unsigned_abs()]),
        _ => Err(ExportError::TooLarge {
            format,
            what: "more than two thousand million vertices or triangles",
        }),
    }
}
