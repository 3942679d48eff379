//! Stereographic projection is an inversion: it lifts the circles of a plane to circles of a sphere
//! (figures 2.8, 2.9).

use super::GalleryError;
use super::motif::{ball, ring, shell};
use super::palette::{SLATE, course, glass, solid};
use crate::export::{Scene, View};
use crate::mesh::{self, Mesh};
use ga_cga::{Circle, DualPlane, DualSphere, Point, Rotor, Vector3};
use std::f64::consts::TAU;

/// The pole that is projected from; the sphere of radius one stands on the plane.
const POLE: [f64; 3] = [0.0, 0.0, 2.0];

/// The number of circles in the plane, and their place and size.
const CIRCLES: u32 = 12;
const DISTANCE: f64 = 1.7;
const RADIUS: f64 = 0.42;

/// The sphere about the pole that the plane touches: inversion in it exchanges plane and sphere.
fn inversion() -> DualSphere {
    let [x, y, z] = POLE;
    DualSphere::with_radius(Vector3::new(x, y, z), 2.0)
}

fn plane() -> DualPlane {
    DualPlane::at_distance(Vector3::new(0.0, 0.0, 1.0), 0.0)
}

/// The image of the plane: the sphere of radius one about (0, 0, 1).
fn sphere() -> DualSphere {
    inversion().apply(plane())
}

/// Three points of each circle in the plane: a wreath, and two circles about its centre.
fn figures() -> Vec<[Point; 3]> {
    let z = Vector3::new(0.0, 0.0, 1.0);
    let turned = |point: Vector3, part: f64| {
        let turn = Rotor::about_axis(z, part * TAU).unwrap_or(Rotor::identity());
        turn.apply(point)
    };
    let about = |center: Vector3, radius: f64| {
        let arm = Vector3::new(radius, 0.0, 0.0);
        [0.0, 1.0 / 3.0, 2.0 / 3.0].map(|part| Point::from(center + turned(arm, part)))
    };
    let wreath = (0..CIRCLES).map(|i| {
        let part = f64::from(i) / f64::from(CIRCLES);
        about(turned(Vector3::new(DISTANCE, 0.0, 0.0), part), RADIUS)
    });
    let rings = [DISTANCE - RADIUS, DISTANCE + RADIUS, 0.55];
    let rings = rings.map(|radius| about(Vector3::default(), radius));
    wreath.chain(rings).collect()
}

fn through([a, b, c]: [Point; 3]) -> Circle {
    a ^ b ^ c
}

pub(super) fn scene() -> Result<Scene, GalleryError> {
    let mut scene = Scene::new(
        "stereographic",
        "Stereographic projection",
        "Inversion in a sphere about the north pole exchanges the plane and the sphere that stands on it. \
         Circles go to circles and touch as they did, each point along the straight line through the \
         pole. What the conformal model adds to space are these two dimensions more.",
    );
    let white = scene.add_material(glass("sphere", [214, 226, 238], 0.5)?);
    scene.add("sphere", shell(sphere())?, white)?;
    let floor = scene.add_material(solid("plane", [236, 238, 242])?);
    scene.add(
        "plane",
        mesh::disc([0.0, 0.0, -0.03], [0.0, 0.0, 1.0], 2.7, 128)?,
        floor,
    )?;
    let figures = figures();
    let mut lines = Vec::new();
    for (i, points) in figures.iter().enumerate() {
        let part = i as f64 / (figures.len() - 1) as f64;
        let name = format!("circle {i}");
        let material = scene.add_material(solid(&name, course(part))?);
        let flat = through(*points);
        let lifted: Circle = inversion().apply(flat);
        scene.add(&name, ring(flat, 0.022)?, material)?;
        scene.add(&name, ring(lifted, 0.022)?, material)?;
        if i % 3 == 0 {
            let [point, ..] = points;
            lines.push(mesh::cylinder(
                POLE,
                point.position().to_array(),
                0.009,
                10,
            )?);
        }
    }
    let slate = scene.add_material(solid("lines", SLATE)?);
    scene.add("lines", Mesh::joined(&lines)?, slate)?;
    scene.add("pole", ball(POLE, 0.07)?, slate)?;
    scene.set_view(View {
        azimuth: -1.1,
        elevation: 0.42,
    })?;
    Ok(scene)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_plane_goes_to_the_sphere_that_stands_on_it() {
        let sphere = sphere();
        let center = sphere.center().unwrap_or_default();
        assert!(center.distance(Point::at(0.0, 0.0, 1.0)) < 1e-15);
        assert!((sphere.radius_squared().unwrap_or_default() - 1.0).abs() < 1e-14);
    }

    #[test]
    fn points_go_along_lines_through_the_pole_and_stay_on_their_circle() {
        let [x, y, z] = POLE;
        let pole = Vector3::new(x, y, z);
        for points in figures() {
            let lifted: Circle = inversion().apply(through(points));
            for point in points {
                let image = point.image_under(inversion()).unwrap_or_default();
                let ray = (image.position() - pole) ^ (point.position() - pole);
                assert!(ray.norm() < 1e-13);
                assert!((image ^ lifted).norm() < 1e-11 * lifted.norm());
                assert!(image.scalar_product(sphere()).abs() < 1e-13);
            }
        }
    }
}
