//! Decides what the figures of symmetry repeat: a curved horn that winds up as it grows thin, so that
//! neither a turn nor a mirror leaves it as it is.

use super::GalleryError;
use super::motif::ball;
use super::palette::{BLUE, ORANGE, solid};
use crate::crystallography::Isometry;
use crate::export::{MaterialId, Scene};
use crate::mesh::Mesh;
use ga_cga::{Point, Vector3};

/// The balls that a horn is made of.
const BALLS: u32 = 22;

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
    let balls = (0..BALLS).map(|i| {
        let part = f64::from(i) / f64::from(BALLS - 1);
        let (sine, cosine) = (WINDING * part).sin_cos();
        let spread = 0.52 * size * (1.0 - 0.35 * part);
        let at = centre.position()
            + (aside * cosine + across * sine) * spread
            + out * (size * (0.45 - 1.0 * part));
        ball(at.to_array(), size * (0.46 - 0.36 * part))
    });
    Ok(Mesh::joined(&balls.collect::<Result<Vec<_>, _>>()?)?)
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
    let degenerate = GalleryError::Degenerate {
        what: "the direction of a motif",
    };
    let Some(out) = along.normalized() else {
        return Err(degenerate);
    };
    // What of the axes is least along it, made perpendicular.
    let [x, y, z] = out.to_array().map(f64::abs);
    let start = if x <= y && x <= z {
        Vector3::new(1.0, 0.0, 0.0)
    } else if y <= z {
        Vector3::new(0.0, 1.0, 0.0)
    } else {
        Vector3::new(0.0, 0.0, 1.0)
    };
    let aside: Vector3 = start.reject(out);
    aside
        .normalized()
        .map(|aside| [out, aside])
        .ok_or(degenerate)
}
