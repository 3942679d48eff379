//! Decides what the figures of symmetry repeat: a curved horn that winds up as it grows thin, so that
//! neither a turn nor a mirror leaves it as it is.

use super::GalleryError;
use super::motif::ball;
use super::palette::{BLUE, ORANGE, solid};
use crate::crystallography::Isometry;
use crate::export::{MaterialId, Scene};
use crate::mesh::Mesh;
use ga_cga::{Point, Vector3};
use std::f64::consts::TAU;

/// The rings of a horn, and the points of a ring.
const RINGS: u32 = 40;
const SIDES: u32 = 20;

/// The turn of the horn from its mouth to its tip, in radians.
const WINDING: f64 = 4.2;

/// A horn around a point: its mouth is towards `out`, and it winds from `aside` about `out`. Both are at
/// right angles and of unit length; its size is about that of a ball of this radius.
pub(super) fn horn(
    centre: Point,
    out: Vector3,
    aside: Vector3,
    size: f64,
) -> Result<Mesh, GalleryError> {
    // A quarter turn on about `out`.
    let across: Vector3 = aside.left_contract(out.orthogonal_plane());
    let along = |part: f64| {
        let (sine, cosine) = (WINDING * part).sin_cos();
        let spread = 0.52 * size * (1.0 - 0.35 * part);
        centre.position()
            + (aside * cosine + across * sine) * spread
            + out * (size * (0.45 - 1.0 * part))
    };
    let radius = |part: f64| size * (0.46 - 0.36 * part);
    let mut positions = Vec::new();
    for ring in 0..RINGS {
        let part = f64::from(ring) / f64::from(RINGS - 1);
        // The axis of the horn never comes to lie along `out`, so that this frame turns evenly.
        let [ahead, up] = frame_beside(along(part + 1e-4) - along(part - 1e-4), out)?;
        let side: Vector3 = up.left_contract(ahead.orthogonal_plane());
        for point in 0..SIDES {
            let (sine, cosine) = (TAU * f64::from(point) / f64::from(SIDES)).sin_cos();
            let spoke = (up * cosine + side * sine) * radius(part);
            positions.push((along(part) + spoke).to_array());
        }
    }
    let mut triangles = Vec::new();
    for ring in 0..RINGS - 1 {
        for point in 0..SIDES {
            let next = (point + 1) % SIDES;
            let [a, b] = [ring * SIDES + point, ring * SIDES + next];
            triangles.extend([[a, b, b + SIDES], [a, b + SIDES, a + SIDES]]);
        }
    }
    let wall = Mesh::from_triangles(positions, triangles)?;
    let ends = [0.0, 1.0].map(|part| ball(along(part).to_array(), radius(part)));
    let [mouth, tip] = ends;
    Ok(Mesh::joined(&[wall, mouth?, tip?])?)
}

/// The unit vector along a vector, and the one at right angles to it that is nearest to another.
fn frame_beside(along: Vector3, other: Vector3) -> Result<[Vector3; 2], GalleryError> {
    let unit = along.normalized().and_then(|ahead| {
        let up: Vector3 = other.reject(ahead);
        Some([ahead, up.normalized()?])
    });
    unit.ok_or(GalleryError::Degenerate {
        what: "the direction of a motif",
    })
}

/// The materials of copies that were turned, blue, and of those that were mirrored, orange.
pub(super) fn materials(scene: &mut Scene) -> Result<[MaterialId; 2], GalleryError> {
    let [turned, mirrored] = [solid("turned", BLUE)?, solid("mirrored", ORANGE)?];
    Ok([scene.add_material(turned), scene.add_material(mirrored)])
}

/// The point at this distance from the origin whose images are farthest from it, of a few hundred, and the
/// distance of the nearest image.
pub(super) fn roomy(isometries: &[Isometry], radius: f64) -> (Point, f64) {
    let room = |point: Point| {
        let images = isometries
            .iter()
            .map(|isometry| isometry.apply(point).distance(point));
        images.filter(|d| *d > 0.0).fold(2.0 * radius, f64::min)
    };
    let candidates = (0..400).map(|i| {
        // The spiral of the golden angle over the sphere.
        let height = 1.0 - (f64::from(i) + 0.5) / 200.0;
        let (sine, cosine) = (2.399_963_229_728_653 * f64::from(i)).sin_cos();
        let across = (1.0 - height * height).max(0.0).sqrt();
        Point::from(Vector3::new(across * cosine, across * sine, height) * radius)
    });
    let start = Point::at(radius, 0.0, 0.0);
    candidates.fold((start, 0.0), |(best, least), point| {
        let here = room(point);
        if here > least {
            (point, here)
        } else {
            (best, least)
        }
    })
}

/// Two unit vectors at right angles, the first along the one that is given.
pub(super) fn frame(along: Vector3) -> Result<[Vector3; 2], GalleryError> {
    // What of the axes is least along it.
    let [x, y, z] = along.to_array().map(f64::abs);
    let start = if x <= y && x <= z {
        Vector3::new(1.0, 0.0, 0.0)
    } else if y <= z {
        Vector3::new(0.0, 1.0, 0.0)
    } else {
        Vector3::new(0.0, 0.0, 1.0)
    };
    frame_beside(along, start)
}
