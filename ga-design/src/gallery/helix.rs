//! Regular tetrahedra stacked face to face wind up in a helix; one motor carries each to the next (the
//! screw of figure 2.14e).

use super::GalleryError;
use super::motif::{ball, coordinates};
use super::palette::{BLUE, ORANGE, YELLOW, between, glass, solid};
use crate::export::{Scene, View};
use crate::mesh::{self, Ends, Mesh};
use ga_cga::{Motor, Point, Rotor, Translator, Vector3};

/// The number of corners.
const CORNERS: usize = 20;

/// The motor of the helix of unit edges: it turns by arccos(−2/3) and climbs by 1/√10 (H. S. M. Coxeter,
/// *Regular Complex Polytopes*, and *Canad. Math. Bull.* 28 (1985) 385–393).
fn step() -> Result<Motor, GalleryError> {
    let axis = Vector3::new(1.0, 0.0, 0.0);
    let rotor = Rotor::about_axis(axis, (-2.0_f64 / 3.0).acos());
    let rotor = rotor.ok_or(GalleryError::Degenerate {
        what: "the axis of the helix",
    })?;
    Ok(Motor::rigid(rotor, Translator::by(axis * 0.1_f64.sqrt())))
}

/// The corners: one point and its images under the powers of the motor.
fn corners() -> Result<Vec<Point>, GalleryError> {
    let step = step()?;
    // The distance of the corners from the axis, for edges of length one.
    let first = Point::at(0.0, 0.0, 0.27_f64.sqrt());
    Ok(
        std::iter::successors(Some(first), |&last| Some(step.apply(last)))
            .take(CORNERS)
            .collect(),
    )
}

pub(super) fn scene() -> Result<Scene, GalleryError> {
    let mut scene = Scene::new(
        "tetrahedral-helix",
        "Helix of tetrahedra",
        "Regular tetrahedra stacked face to face. A single motor, a turn of 131.81° with a climb of \
         1/√10, carries each corner to the next: all edges come out equal, and no two tetrahedra ever \
         stand in the same direction.",
    );
    let corners = corners()?;
    let places = coordinates(&corners);
    // Corners one, two and three steps apart are joined: three families of screw lines.
    for (apart, color) in [(1, BLUE), (2, YELLOW), (3, ORANGE)] {
        let name = format!("edges {apart}");
        let ends = places.iter().zip(places.iter().skip(apart));
        let rods = ends.map(|(&from, &to)| mesh::tube(&[from, to], Ends::Capped, 0.045, 16));
        let rods = rods.collect::<Result<Vec<_>, _>>()?;
        let material = scene.add_material(solid(&name, color)?);
        scene.add(&name, Mesh::joined(&rods)?, material)?;
    }
    let white = scene.add_material(solid("corners", [232, 235, 240])?);
    let balls = places
        .iter()
        .map(|&place| ball(place, 0.1))
        .collect::<Result<Vec<_>, _>>()?;
    scene.add("corners", Mesh::joined(&balls)?, white)?;
    // The outer faces have corners 0, 1, 3 and 0, 2, 3 steps on.
    let mut faces = Vec::new();
    for window in places.windows(4) {
        if let [first, second, third, fourth] = *window {
            faces.push(Mesh::from_triangles(
                vec![first, second, fourth],
                vec![[0, 1, 2]],
            )?);
            faces.push(Mesh::from_triangles(
                vec![first, fourth, third],
                vec![[0, 1, 2]],
            )?);
        }
    }
    let sheet = scene.add_material(glass("faces", between(BLUE, [255; 3], 0.55), 0.35)?);
    scene.add("faces", Mesh::joined(&faces)?, sheet)?;
    scene.set_view(View {
        azimuth: -1.15,
        elevation: 0.3,
    })?;
    Ok(scene)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_edges_have_length_one() -> Result<(), GalleryError> {
        let corners = corners()?;
        for (i, corner) in corners.iter().enumerate() {
            for apart in 1..=3 {
                if let Some(other) = corners.get(i + apart) {
                    assert!((corner.distance(*other) - 1.0).abs() < 1e-13);
                }
            }
        }
        Ok(())
    }
}
