//! A vertex of four creases folded by spheres: the fourth corner is where three of them meet, in one of
//! two places (figures 2.15–2.17).

use super::GalleryError;
use super::motif::{ball, face, ring, shell};
use super::palette::{BLUE, ORANGE, SLATE, TEAL, YELLOW, between, glass, solid};
use crate::export::{Scene, View};
use crate::folding::{FoldMode, FoldedVertex, Vertex};
use crate::mesh::{self, Ends, Mesh};
use ga_cga::{Circle, DualSphere, Point};

/// The sectors between the creases, in degrees: those across from each other make half a turn, so that
/// the vertex folds flat.
const SECTORS: [f64; 4] = [62.0, 84.0, 118.0, 96.0];

/// The fold of the driven crease that is shown.
const FOLD: f64 = 1.25;

fn vertex() -> Result<Vertex, GalleryError> {
    Ok(Vertex::new(SECTORS.map(f64::to_radians))?)
}

/// The origin, where the vertex is.
fn middle() -> Point {
    Point::at(0.0, 0.0, 0.0)
}

/// The sphere about a corner that passes through the fourth.
fn reach(center: Point, corner: Point) -> DualSphere {
    let distance = center.distance(corner);
    DualSphere::about(center, distance * distance)
}

/// The circle on which the third corner turns: where the spheres about the vertex and the second corner
/// meet.
fn orbit(folded: FoldedVertex) -> Circle {
    let [_, second, third, _] = folded.corners();
    (reach(middle(), third) ^ reach(second, third)).undual()
}

pub(super) fn scene() -> Result<Scene, GalleryError> {
    let mut scene = Scene::new(
        "folded-vertex",
        "A vertex folded by spheres",
        "Four creases meet in a vertex, and one of them is driven: its panel turns with the blue corner on \
         the dark circle. Three spheres keep the lengths of the paper: one about the vertex, on which \
         those about the green and the blue corner are seen as circles. They meet in two places, orange \
         and yellow, which are the two modes in which the vertex folds.",
    );
    let folded = vertex()?.fold(FOLD, FoldMode::Alike)?;
    let other = vertex()?.fold(FOLD, FoldMode::Opposed)?;
    let corners = folded.corners();
    let [first, second, third, fourth] = corners;
    let [.., ghost] = other.corners();

    let paper = scene.add_material(solid("paper", [236, 230, 214])?);
    for (i, from) in corners.into_iter().enumerate() {
        let to = corners[(i + 1) % 4];
        scene.add("panel", face(&[middle(), from, to])?, paper)?;
    }
    let slate = scene.add_material(solid("creases", SLATE)?);
    let rod = |from: Point, to: Point, radius: f64| {
        let line = [from, to].map(|point| point.position().to_array());
        mesh::tube(&line, Ends::Capped, radius, 16)
    };
    let rods = corners.map(|corner| rod(middle(), corner, 0.016));
    let rods = rods.into_iter().collect::<Result<Vec<Mesh>, _>>()?;
    scene.add("creases", Mesh::joined(&rods)?, slate)?;
    let pale = scene.add_material(glass("other mode", between(YELLOW, [255; 3], 0.4), 0.45)?);
    for pair in [[third, ghost], [ghost, first]] {
        scene.add("other mode", face(&[middle(), pair[0], pair[1]])?, pale)?;
    }

    let around = reach(middle(), fourth);
    let sheet = scene.add_material(glass("sphere about the vertex", [150, 170, 196], 0.16)?);
    scene.add("sphere about the vertex", shell(around)?, sheet)?;
    for (name, color, center) in [("first sphere", TEAL, first), ("third sphere", BLUE, third)] {
        let circle = (around ^ reach(center, fourth)).undual();
        let material = scene.add_material(solid(name, color)?);
        scene.add(name, ring(circle, 0.014)?, material)?;
    }
    let balls = [
        ("vertex", middle(), SLATE, 0.045),
        ("first corner", first, TEAL, 0.045),
        ("second corner", second, SLATE, 0.045),
        ("third corner", third, BLUE, 0.06),
        ("fourth corner", fourth, ORANGE, 0.075),
        ("fourth corner in the other mode", ghost, YELLOW, 0.075),
    ];
    for (name, at, color, radius) in balls {
        let material = scene.add_material(solid(name, color)?);
        scene.add(name, ball(at.position().to_array(), radius)?, material)?;
    }
    scene.add(
        "circle of the third corner",
        ring(orbit(folded), 0.01)?,
        slate,
    )?;
    scene.set_view(View {
        azimuth: -2.2,
        elevation: 0.45,
    })?;
    Ok(scene)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_modes_keep_the_three_distances() -> Result<(), GalleryError> {
        let flat = vertex()?.flat().corners();
        for mode in [FoldMode::Alike, FoldMode::Opposed] {
            for i in 1..=9 {
                let [first, _, third, fourth] =
                    vertex()?.fold(f64::from(i) * 0.33, mode)?.corners();
                for (moved, before) in [(middle(), middle()), (first, flat[0]), (third, flat[2])] {
                    let change = moved.distance(fourth) - before.distance(flat[3]);
                    assert!(change.abs() < 1e-10);
                }
            }
        }
        Ok(())
    }

    #[test]
    fn the_third_corner_is_on_its_circle() -> Result<(), GalleryError> {
        let circle = orbit(vertex()?.fold(FOLD, FoldMode::Alike)?);
        for i in 1..=9 {
            let [_, _, third, _] = vertex()?
                .fold(f64::from(i) * 0.3, FoldMode::Alike)?
                .corners();
            assert!((third ^ circle).norm() < 1e-12);
        }
        Ok(())
    }
}
