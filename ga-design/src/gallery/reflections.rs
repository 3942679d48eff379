//! Two reflections make a rotation by twice the angle between the mirrors (figure 2.6, section 2.2).
//!
//! ```text
//!     F″ = R[F]      mirror 2
//!         ·   .      /
//!            .  F′  /        R = π₂ π₁
//!              .   /.
//!        axis  ●───────── mirror 1
//!                    .
//!                      F
//! ```

use super::GalleryError;
use super::motif::{Letter, path};
use super::palette::{BLUE, ORANGE, SLATE, TEAL, glass, solid};
use crate::export::{Scene, View};
use crate::mesh;
use ga_cga::{DualPlane, Motor, Point, Rotor, Vector3};

/// The directions of the two mirrors, as angles from x towards y in radians.
const MIRRORS: [f64; 2] = [0.95, 2.05];

/// The direction in which the first letter lies.
const START: f64 = 0.42;

/// The distance of the letter's foot from the axis.
const DISTANCE: f64 = 1.35;

/// How far the mirrors reach from the axis, and how high.
const REACH: f64 = 2.9;
const HEIGHT: f64 = 0.6;

/// The direction in the floor at this angle.
fn along(angle: f64) -> [f64; 3] {
    [angle.cos(), angle.sin(), 0.0]
}

/// The mirror through the z axis in this direction, as a dual plane of unit normal.
fn mirror(angle: f64) -> DualPlane {
    DualPlane::at_distance(Vector3::new(-angle.sin(), angle.cos(), 0.0), 0.0)
}

/// A letter lying on the floor, its stem pointing away from the axis.
fn letter() -> Letter {
    let foot = along(START).map(|c| DISTANCE * c);
    let across = along(START - std::f64::consts::FRAC_PI_2);
    Letter::standing(foot, across, along(START))
}

/// The rotation about z by an angle.
fn turn(angle: f64) -> Result<Rotor, GalleryError> {
    let axis = Vector3::new(0.0, 0.0, 1.0);
    Rotor::about_axis(axis, angle).ok_or(GalleryError::Degenerate {
        what: "the axis of the mirrors",
    })
}

/// The points that the rotation carries a point through, from no angle to the whole.
fn arc(start: Point, angle: f64) -> Result<Vec<Point>, GalleryError> {
    (0..=64)
        .map(|i| Ok(turn(angle * f64::from(i) / 64.0)?.apply(start)))
        .collect()
}

pub(super) fn scene() -> Result<Scene, GalleryError> {
    let mut scene = Scene::new(
        "two-reflections",
        "Two reflections make a rotation",
        "The blue letter is reflected in the first mirror (teal: it reads backwards) and its image in \
         the second (orange: it reads again). The product of the two mirrors is the rotor that does \
         both at once; it turns by twice the angle between them.",
    );
    let [first, second] = MIRRORS.map(mirror);
    let rotation: Motor = second * first;
    let given = letter();
    let reflected = given.moved(|point| first.apply(point));
    let turned = given.moved(|point| rotation.apply(point));
    let letters = [
        ("letter", &given, BLUE),
        ("reflected once", &reflected, TEAL),
        ("reflected twice", &turned, ORANGE),
    ];
    for (name, letter, color) in letters {
        let material = scene.add_material(solid(name, color)?);
        letter.draw(&mut scene, name, material, 0.075)?;
    }

    let slate = scene.add_material(solid("axis", SLATE)?);
    scene.add(
        "axis",
        mesh::cylinder([0.0, 0.0, -0.1], [0.0, 0.0, 2.0 * HEIGHT], 0.035, 20)?,
        slate,
    )?;
    let orange = scene.add_material(solid("rotation", ORANGE)?);
    let whole = 2.0 * (MIRRORS[1] - MIRRORS[0]);
    scene.add("rotation", path(&arc(given.foot(), whole)?, 0.022)?, orange)?;
    let foot_of_mirror = along(MIRRORS[0]).map(|c| 0.75 * c);
    let [x, y, z] = foot_of_mirror;
    let between = arc(Point::at(x, y, z), whole / 2.0)?;
    scene.add("angle between the mirrors", path(&between, 0.022)?, slate)?;

    let sheet = scene.add_material(glass("mirror", [120, 160, 196], 0.34)?);
    let rim = scene.add_material(solid("rim", [128, 150, 172])?);
    for (angle, name) in MIRRORS.into_iter().zip(["first mirror", "second mirror"]) {
        let half = along(angle).map(|c| c * REACH / 2.0);
        let centre = [half[0], half[1], HEIGHT - 0.1];
        let face = mesh::parallelogram(centre, half, [0.0, 0.0, HEIGHT])?;
        scene.add(name, face, sheet)?;
        let far = along(angle).map(|c| c * REACH);
        let [low, high] = [-0.1, 2.0 * HEIGHT - 0.1];
        let corners = [
            [0.0, 0.0, low],
            [far[0], far[1], low],
            [far[0], far[1], high],
            [0.0, 0.0, high],
        ];
        scene.add(
            name,
            mesh::tube(&corners, mesh::Ends::Closed, 0.014, 12)?,
            rim,
        )?;
    }
    scene.set_view(View {
        azimuth: -1.63,
        elevation: 0.8,
    })?;
    Ok(scene)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_product_of_the_mirrors_does_what_both_do() {
        let [first, second] = MIRRORS.map(mirror);
        let rotation: Motor = second * first;
        for point in letter().points() {
            let both: Point = second.apply(first.apply(point));
            assert!(both.distance(rotation.apply(point)) < 1e-14);
        }
    }

    #[test]
    fn it_turns_by_twice_the_angle_between_them() -> Result<(), GalleryError> {
        let [first, second] = MIRRORS.map(mirror);
        let rotation: Motor = second * first;
        let rotor = turn(2.0 * (MIRRORS[1] - MIRRORS[0]))?;
        for point in letter().points() {
            assert!(rotor.apply(point).distance(rotation.apply(point)) < 1e-14);
        }
        Ok(())
    }
}
