//! The outer product spans: vectors, an area, a volume (figures 2.1–2.3), and the meet of two planes
//! (figure 2.4).

use super::GalleryError;
use super::palette::{BLUE, ORANGE, SLATE, TEAL, YELLOW, glass, solid};
use crate::export::{Scene, View};
use crate::mesh::{self, Ends, Mesh};
use ga_cga::{Bivector3, Trivector3, Vector3};

/// The three vectors that span.
const VECTORS: [[f64; 3]; 3] = [[1.5, 0.25, 0.1], [-0.3, 1.4, 0.2], [0.25, 0.1, 1.3]];

/// Where the stations stand.
const PLACES: [f64; 4] = [-4.0, -1.7, 0.9, 4.1];

fn vectors() -> [Vector3; 3] {
    VECTORS.map(Vector3::from)
}

/// The planes that meet, as bivectors through the origin.
fn planes() -> [Bivector3; 2] {
    let [a, b, c] = [[1.0, 0.3, 0.15], [-0.2, 1.0, 0.25], [0.1, 0.5, 1.0]].map(Vector3::from);
    [a ^ b, b ^ c]
}

/// The line in which two planes through the origin meet: the dual of the outer product of their duals
/// (2.25), in three dimensions.
fn meet([first, second]: [Bivector3; 2]) -> Vector3 {
    let dual = |plane: Bivector3| plane * Trivector3::new(-1.0);
    (dual(first) ^ dual(second)) * Trivector3::new(1.0)
}

/// Two directions of a plane at a right angle to each other: the first along a vector of the plane.
fn sides(plane: Bivector3, along: Vector3) -> [Vector3; 2] {
    [along, along.left_contract(plane)].map(|side| side / side.norm())
}

fn moved(place: f64, vector: Vector3) -> [f64; 3] {
    (vector + Vector3::new(place, 0.0, 0.0)).to_array()
}

pub(super) fn scene() -> Result<Scene, GalleryError> {
    let mut scene = Scene::new(
        "spans",
        "What vectors span, and where planes meet",
        "Three vectors; the area that two of them span, a ∧ b; the volume of all three, a ∧ b ∧ c. On the \
         right two planes and the line in which they meet, which is the dual of what their duals span.",
    );
    let [a, b, c] = vectors();
    let mut materials = Vec::new();
    for (name, color) in [("a", BLUE), ("b", TEAL), ("c", YELLOW)] {
        materials.push(scene.add_material(solid(name, color)?));
    }
    let arrow = |scene: &mut Scene, place: f64, from: Vector3, vector: Vector3, i: usize| {
        let [from, to] = [from, from + vector].map(|end| moved(place, end));
        let Some(&material) = materials.get(i) else {
            return Ok(());
        };
        scene.add("vector", mesh::arrow(from, to, 0.045, 24)?, material)?;
        Ok::<(), GalleryError>(())
    };
    let origin = Vector3::default();
    let [first, second, third, fourth] = PLACES;
    for (i, vector) in [a, b, c].into_iter().enumerate() {
        arrow(&mut scene, first, origin, vector, i)?;
        arrow(&mut scene, third, origin, vector, i)?;
    }
    arrow(&mut scene, second, origin, a, 0)?;
    arrow(&mut scene, second, a, b, 1)?;

    let orange = scene.add_material(glass("span", ORANGE, 0.5)?);
    let edge = scene.add_material(solid("edge", SLATE)?);
    let face = |place: f64, corner: Vector3, u: Vector3, v: Vector3| {
        let centre = moved(place, corner + (u + v) * 0.5);
        mesh::parallelogram(centre, (u * 0.5).to_array(), (v * 0.5).to_array())
    };
    scene.add("area", face(second, origin, a, b)?, orange)?;
    let outline = [origin, a, a + b, b].map(|corner| moved(second, corner));
    scene.add("edge", mesh::tube(&outline, Ends::Closed, 0.014, 12)?, edge)?;
    let faces = [
        face(third, origin, a, b)?,
        face(third, origin, b, c)?,
        face(third, origin, c, a)?,
        face(third, c, a, b)?,
        face(third, a, b, c)?,
        face(third, b, c, a)?,
    ];
    scene.add("volume", Mesh::joined(&faces)?, orange)?;
    let edges = mesh::cell_edges(moved(third, origin), [a, b, c].map(Vector3::to_array));
    let rods = edges.iter();
    let rods = rods.map(|ends| mesh::tube(ends, Ends::Capped, 0.014, 12));
    let edges = Mesh::joined(&rods.collect::<Result<Vec<_>, _>>()?)?;
    scene.add("edge", edges, edge)?;

    let line = meet(planes());
    let direction = line / line.norm();
    for (plane, color) in planes().into_iter().zip([BLUE, TEAL]) {
        let material = scene.add_material(glass("plane", color, 0.42)?);
        let [u, v] = sides(plane, direction);
        let centre = moved(fourth, Vector3::new(0.0, 0.0, 0.5));
        let pane = mesh::parallelogram(centre, (u * 1.25).to_array(), (v * 1.2).to_array())?;
        scene.add("plane", pane, material)?;
    }
    let ends = [-1.6, 1.6].map(|t| moved(fourth, Vector3::new(0.0, 0.0, 0.5) + direction * t));
    let bright = scene.add_material(solid("meet", ORANGE)?);
    let [from, to] = ends;
    scene.add("meet", mesh::arrow(from, to, 0.05, 24)?, bright)?;
    scene.set_view(View {
        azimuth: -1.3,
        elevation: 0.5,
    })?;
    Ok(scene)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_meet_is_in_both_planes() {
        let line = meet(planes());
        assert!(line.norm() > 0.1);
        for plane in planes() {
            assert!((line ^ plane).norm() < 1e-14);
            let [u, v] = sides(plane, line);
            assert!((u ^ plane).norm() < 1e-14 && (v ^ plane).norm() < 1e-14);
            assert!(u.scalar_product(v).abs() < 1e-14);
        }
    }

    #[test]
    fn the_volume_is_the_determinant() {
        let [a, b, c] = vectors();
        let matrix = glam::DMat3::from_cols_array_2d(&VECTORS);
        let Trivector3 { e123 } = a ^ b ^ c;
        assert!((e123 - matrix.determinant()).abs() < 1e-14);
    }
}
