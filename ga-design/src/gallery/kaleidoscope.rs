//! One point and three mirrors make a polyhedron: the 120 images of a point under the reflections of
//! the icosahedron (point group m -3 -5, section 3.1).

use super::GalleryError;
use super::palette::{BLUE, ORANGE, solid};
use crate::export::{Material, Placement, Scene, View};
use crate::mesh;
use ga_cga::{DualPlane, Point, Vector3};
use glam::{DMat3, DVec3};
use std::collections::VecDeque;

/// Images closer than this are the same.
const SAME: f64 = 1e-9;

/// More images than any finite group of three mirrors in general position needs.
const MOST_IMAGES: usize = 240;

/// The unit normals of three mirrors, two of which meet at π/5, two at π/3 and two at π/2 (the roots of
/// H₃).
fn normals() -> [DVec3; 3] {
    let [fifth, third] = [5.0, 3.0].map(|n| (std::f64::consts::PI / n).cos());
    // The second makes −cos π/5 with the first, the third −cos π/3 with the second, 0 with the first.
    let sine = (1.0 - fifth * fifth).sqrt();
    let side = -third / sine;
    [
        DVec3::X,
        DVec3::new(-fifth, sine, 0.0),
        DVec3::new(0.0, side, (1.0 - side * side).max(0.0).sqrt()),
    ]
}

/// The mirrors as dual planes through the origin.
fn mirrors() -> [DualPlane; 3] {
    normals().map(|n| DualPlane::at_distance(Vector3::new(n.x, n.y, n.z), 0.0))
}

/// The point as far from each mirror as from the others, one unit from the origin: its images are the
/// corners of a polyhedron whose edges are all equal.
fn seed() -> Point {
    let [a, b, c] = normals();
    let at = DMat3::from_cols(a, b, c).transpose().inverse() * DVec3::ONE;
    let at = at.normalize();
    Point::at(at.x, at.y, at.z)
}

/// An image of the seed.
#[derive(Clone, Copy, Debug)]
struct Image {
    point: Point,
    /// Whether an odd number of mirrors made it.
    is_mirrored: bool,
}

/// The images of a point, and the pairs of them that one mirror (or its image) exchanges.
fn images(start: Point) -> (Vec<Image>, Vec<[usize; 2]>) {
    let mirrors = mirrors();
    let mut images = vec![Image {
        point: start,
        is_mirrored: false,
    }];
    // The mirrors of an image are those of the seed, carried along with it.
    let mut pending = VecDeque::from([(0, mirrors)]);
    let mut edges = Vec::new();
    while let Some((here, around)) = pending.pop_front() {
        let Some(image) = images.get(here).copied() else {
            continue;
        };
        for mirror in around {
            let point = mirror.apply(image.point);
            let known = images
                .iter()
                .position(|other| other.point.distance(point) < SAME);
            let there = known.unwrap_or(images.len());
            if known.is_none() && images.len() < MOST_IMAGES {
                images.push(Image {
                    point,
                    is_mirrored: !image.is_mirrored,
                });
                pending.push_back((there, around.map(|other| mirror.apply(other))));
            }
            if here < there {
                edges.push([here, there]);
            }
        }
    }
    (images, edges)
}

pub(super) fn scene() -> Result<Scene, GalleryError> {
    let mut scene = Scene::new(
        "kaleidoscope",
        "Kaleidoscope of the icosahedron",
        "One point between three mirrors and its images under all their reflections: the 120 corners of \
         a polyhedron of squares, hexagons and decagons. Blue corners come from an even number of \
         reflections, which is a rotation; orange ones from an odd number.",
    );
    let (images, edges) = images(seed());
    let scale = 3.0;
    let place = |image: &Image| image.point.position().to_array().map(|c| scale * c);
    let sphere = scene.add_shape("corner", mesh::icosphere(3)?);
    let turned = scene.add_material(solid("turned", BLUE)?);
    let mirrored = scene.add_material(solid("mirrored", ORANGE)?);
    for (number, image) in images.iter().enumerate() {
        let material = if image.is_mirrored { mirrored } else { turned };
        let placement = Placement::at(place(image))?.scaled([0.155; 3])?;
        scene.add_node(format!("corner {number}"), sphere, material, placement)?;
    }
    let rods = edges.iter().filter_map(|pair| {
        let [one, other] = pair.map(|i| images.get(i).map(place));
        Some(mesh::cylinder(one?, other?, 0.055, 14))
    });
    let rods = rods.collect::<Result<Vec<_>, _>>()?;
    let grey = scene.add_material(solid("edges", [196, 202, 210])?);
    scene.add("edges", mesh::Mesh::joined(&rods)?, grey)?;
    // A core hides the far side, which would make the picture hard to read.
    let core = scene.add_shape("core", mesh::icosphere(5)?);
    let white = scene.add_material(Material::new("core", [240, 242, 245]).with_roughness(0.8)?);
    scene.add_node(
        "core",
        core,
        white,
        Placement::default().scaled([0.93 * scale; 3])?,
    )?;
    scene.set_view(View {
        azimuth: -0.9,
        elevation: 0.35,
    })?;
    Ok(scene)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn there_are_120_corners_half_of_them_mirrored_and_180_equal_edges() {
        let (images, edges) = images(seed());
        assert_eq!(images.len(), 120);
        assert_eq!(images.iter().filter(|image| image.is_mirrored).count(), 60);
        assert_eq!(edges.len(), 180);
        // The edge of a truncated icosidodecahedron of circumradius 1 (Coxeter, Regular Polytopes).
        let expected = 2.0 / (31.0 + 12.0 * 5f64.sqrt()).sqrt();
        for [one, other] in edges {
            let length = images[one].point.distance(images[other].point);
            assert!((length - expected).abs() < 1e-12, "{length}");
            assert_ne!(images[one].is_mirrored, images[other].is_mirrored);
        }
    }
}
