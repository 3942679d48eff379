//! The circle through three points, twisted, is the circle through the twisted points (figure 1.1):
//! M\[a∧b∧c\] = M\[a\]∧M\[b\]∧M\[c\].

use super::GalleryError;
use super::motif::{ball, path};
use super::palette::{SLATE, TEAL, YELLOW, course, solid};
use crate::export::{Scene, View};
use crate::mesh::{self, Mesh};
use ga_cga::{Bivector3, Circle, DualSphere, Motor, Point, Rotor, Translator, Trivector3, Vector3};
use std::f64::consts::TAU;

/// The three points.
const POINTS: [[f64; 3]; 3] = [[2.95, 0.15, 0.1], [1.7, -0.3, 0.95], [1.45, 0.25, -0.7]];

/// The twist: an angle about z and a way along it.
const ANGLE: f64 = 0.78 * TAU;
const RISE: f64 = 2.3;

/// The number of circles.
const CIRCLES: u32 = 29;

fn points() -> [Point; 3] {
    POINTS.map(|[x, y, z]| Point::at(x, y, z))
}

fn through([a, b, c]: [Point; 3]) -> Circle {
    a ^ b ^ c
}

/// The motor that has gone this part of the twist.
fn twist(part: f64) -> Result<Motor, GalleryError> {
    let axis = Vector3::new(0.0, 0.0, 1.0);
    let rotor = Rotor::about_axis(axis, part * ANGLE);
    let rotor = rotor.ok_or(GalleryError::Degenerate {
        what: "the axis of the twist",
    })?;
    Ok(Motor::rigid(rotor, Translator::by(axis * (part * RISE))))
}

/// The smallest sphere around a circle, whose centre and radius are those of the circle: the circle
/// contracted onto its plane K∧n_∞.
fn surround(circle: Circle) -> DualSphere {
    circle.left_contract(circle ^ DualSphere::infinity())
}

/// A circle as a ring; its normal is the dual of the bivector that two of its chords span.
fn ring(circle: Circle, [a, b, c]: [Point; 3], thickness: f64) -> Result<Mesh, GalleryError> {
    let missing = GalleryError::Degenerate {
        what: "the circle through three points on a line",
    };
    let around = surround(circle);
    let Some((centre, square)) = around.center().zip(around.radius_squared()) else {
        return Err(missing);
    };
    let chords: Bivector3 = (b.position() - a.position()) ^ (c.position() - a.position());
    let normal: Vector3 = chords * Trivector3::new(-1.0);
    Ok(mesh::torus(
        centre.position().to_array(),
        normal.to_array(),
        square.abs().sqrt(),
        thickness,
        96,
        10,
    )?)
}

pub(super) fn scene() -> Result<Scene, GalleryError> {
    let mut scene = Scene::new(
        "covariance",
        "A twisted circle",
        "Three points, the circle through them, and a motor that turns and lifts. The thin rings are the \
         circle moved as a whole, the balls are the points moved one by one along their screw lines: \
         every ring passes through its three balls, because the motion of a product is the product of \
         the moved factors.",
    );
    let start = points();
    let circle = through(start);
    for step in 0..CIRCLES {
        let part = f64::from(step) / f64::from(CIRCLES - 1);
        let motor = twist(part)?;
        let is_end = step == 0 || step == CIRCLES - 1;
        let color = course(part);
        let name = format!("circle {step}");
        let material = scene.add_material(solid(&name, color)?);
        let thickness = if is_end { 0.05 } else { 0.016 };
        let moved = start.map(|point| motor.apply(point));
        scene.add(
            &name,
            ring(motor.apply(circle), moved, thickness)?,
            material,
        )?;
    }
    for (number, (point, color)) in start.into_iter().zip([TEAL, YELLOW, SLATE]).enumerate() {
        let name = format!("point {number}");
        let material = scene.add_material(solid(&name, color)?);
        let line = (0..=90).map(|i| Ok(twist(f64::from(i) / 90.0)?.apply(point)));
        let line = line.collect::<Result<Vec<_>, GalleryError>>()?;
        scene.add(&name, path(&line, 0.03)?, material)?;
        for end in [line.first(), line.last()].into_iter().flatten() {
            scene.add(&name, ball(end.position().to_array(), 0.13)?, material)?;
        }
    }
    let axis = scene.add_material(solid("axis", [150, 158, 170])?);
    scene.add(
        "axis",
        mesh::cylinder([0.0, 0.0, -1.0], [0.0, 0.0, RISE + 1.0], 0.025, 16)?,
        axis,
    )?;
    scene.set_view(View {
        azimuth: -0.72,
        elevation: 0.42,
    })?;
    Ok(scene)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_moved_circle_is_the_circle_of_the_moved_points() -> Result<(), GalleryError> {
        for step in 0..=20 {
            let motor = twist(f64::from(step) / 20.0)?;
            let whole: Circle = motor.apply(through(points()));
            let parts = through(points().map(|point| motor.apply(point)));
            assert!((whole - parts).norm() < 1e-12 * whole.norm());
        }
        Ok(())
    }

    #[test]
    fn every_point_of_the_drawn_ring_lies_on_the_circle() -> Result<(), GalleryError> {
        let motor = twist(0.37)?;
        let moved = points().map(|point| motor.apply(point));
        let circle: Circle = motor.apply(through(points()));
        let thickness = 1e-4;
        let ring = ring(circle, moved, thickness)?;
        for &[x, y, z] in ring.positions() {
            let off = (Point::at(x, y, z) ^ circle).norm() / circle.norm();
            assert!(off < 20.0 * thickness, "{off}");
        }
        Ok(())
    }

    #[test]
    fn the_centre_is_as_far_from_each_point_as_the_radius() {
        let around = surround(through(points()));
        let centre = around
            .center()
            .unwrap_or_else(|| Point::at(f64::NAN, 0.0, 0.0));
        let radius = around.radius_squared().unwrap_or(f64::NAN).sqrt();
        for point in points() {
            assert!((centre.distance(point) - radius).abs() < 1e-13);
        }
    }
}
