//! Three roots at the angles π/p, π/q and π/2, and the planes that they span (figure 3.1, table 3.1).

use super::GalleryError;
use super::palette::{BLUE, ORANGE, SLATE, TEAL, YELLOW, glass, solid};
use crate::crystallography::{Roots, RootsError};
use crate::export::{MaterialId, Placement, Scene, View};
use crate::mesh::{self, Ends, Mesh};
use ga_cga::Vector3;
use ga_cga::interpolate::{Carry, Way};

/// The angle numbers p and q, in two rows from left to right.
const NUMBERS: [[u32; 2]; 4] = [[2, 2], [3, 3], [4, 3], [5, 3]];

/// The distance of the stations from each other.
const SPACING: f64 = 2.7;

/// The side from which they are looked at, into the corner that the planes make; the stations stand
/// across it.
const AZIMUTH: f64 = 1.2;

/// The steps of an arc.
const STEPS: u32 = 40;

/// The points of the unit sphere from one unit vector to another, on the shortest way (2.38).
fn arc(from: Vector3, to: Vector3) -> Result<Vec<Vector3>, GalleryError> {
    let path = from.path_to(to, Way::Short);
    let path = path.map_err(|_| GalleryError::Degenerate {
        what: "the turn from a root to its opposite",
    })?;
    let steps = (0..=STEPS).map(|step| path.at(f64::from(step) / f64::from(STEPS)));
    Ok(steps.collect())
}

/// The sector between the origin and an arc.
fn sector(arc: &[Vector3]) -> Result<Mesh, GalleryError> {
    let corners = std::iter::once([0.0; 3]).chain(arc.iter().map(|point| point.to_array()));
    let triangles = (1..STEPS + 1).map(|i| [0, i, i + 1]).collect();
    Ok(Mesh::from_triangles(corners.collect(), triangles)?)
}

fn stations() -> Result<Vec<Roots>, RootsError> {
    let numbers = NUMBERS.into_iter();
    numbers.map(|[p, q]| Roots::new(p, q)).collect()
}

pub(super) fn scene() -> Result<Scene, GalleryError> {
    let mut scene = Scene::new(
        "roots",
        "Three roots from two numbers",
        "The normals of three mirrors: a (orange) and b (teal) at the angle π/p, b and c (blue) at π/q, c \
         and a at a right angle. The planes a ∧ b (yellow), b ∧ c (teal) and c ∧ a (blue) meet in them at the \
         angles that the cosine rule gives. Above pq = 22 (brick) and 33 (tetrahedron), below 43 (cube) and 53 \
         (icosahedron).",
    );
    let colors = [ORANGE, TEAL, BLUE];
    let mut roots = Vec::new();
    for (name, color) in ["a", "b", "c"].into_iter().zip(colors) {
        roots.push(scene.add_material(solid(name, color)?));
    }
    let mut planes = Vec::new();
    for (name, color) in ["a∧b", "b∧c", "c∧a"].into_iter().zip([YELLOW, TEAL, BLUE]) {
        planes.push(scene.add_material(glass(name, color, 0.62)?));
    }
    let slate = scene.add_material(solid("arcs", SLATE)?);
    let ball = scene.add_material(glass("unit sphere", [214, 220, 228], 0.16)?);
    let sphere = scene.add_shape("unit sphere", mesh::icosphere(5)?);
    for (number, station) in stations()?.iter().enumerate() {
        let across = ((number % 2) as f64 - 0.5) * SPACING;
        let up = (0.5 - (number / 2) as f64) * SPACING;
        let place = [-AZIMUTH.sin() * across, AZIMUTH.cos() * across, up];
        let placement = Placement::at(place)?;
        let mut put = |name: &str, shape: Mesh, material: MaterialId| {
            let shape = scene.add_shape(name, shape);
            scene.add_node(name, shape, material, placement)
        };
        let [a, b, c] = station.vectors();
        for ((name, root), material) in ["a", "b", "c"].into_iter().zip([a, b, c]).zip(&roots) {
            let arrow = mesh::arrow([0.0; 3], (root * 1.32).to_array(), 0.034, 24)?;
            put(name, arrow, *material)?;
        }
        let sides = [("a∧b", a, b), ("b∧c", b, c), ("c∧a", c, a)];
        for ((name, from, to), material) in sides.into_iter().zip(&planes) {
            let arc = arc(from, to)?;
            put(name, sector(&arc)?, *material)?;
            let line: Vec<_> = arc.iter().map(|point| point.to_array()).collect();
            put("arc", mesh::tube(&line, Ends::Capped, 0.012, 12)?, slate)?;
        }
        scene.add_node("unit sphere", sphere, ball, placement)?;
    }
    scene.set_view(View {
        azimuth: AZIMUTH,
        elevation: 0.3,
    })?;
    Ok(scene)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    #[test]
    fn the_arcs_are_as_long_as_the_angles() -> Result<(), GalleryError> {
        for (roots, [p, q]) in stations()?.iter().zip(NUMBERS) {
            let [a, b, c] = roots.vectors();
            for (from, to, number) in [(a, b, p), (b, c, q), (c, a, 2)] {
                let arc = arc(from, to)?;
                let chords = arc.windows(2).map(|ends| match ends {
                    [start, end] => 2.0 * ((*end - *start).norm() / 2.0).asin(),
                    _ => f64::NAN,
                });
                assert!((chords.sum::<f64>() - PI / f64::from(number)).abs() < 1e-12);
                let on_sphere = |point: &Vector3| (point.norm() - 1.0).abs() < 1e-14;
                assert!(arc.iter().all(on_sphere));
            }
        }
        Ok(())
    }

    #[test]
    fn the_planes_meet_at_the_angles_of_the_cosine_rule() -> Result<(), GalleryError> {
        for roots in stations()? {
            let [a, b, c] = roots.vectors();
            let [alpha, gamma] = [roots.q(), roots.p()].map(|n| PI / f64::from(n));
            let angle = |u, v| {
                let [u, v]: [ga_cga::Bivector3; 2] = [u, v];
                (u.reverse().scalar_product(v) / (u.norm() * v.norm())).acos()
            };
            // (3.6), (3.7): the dihedral angles at a and at c.
            let at_a = (alpha.cos() / gamma.sin()).acos();
            let at_c = (gamma.cos() / alpha.sin()).acos();
            assert!((angle(a ^ b, a ^ c) - at_a).abs() < 1e-13);
            assert!((angle(c ^ b, c ^ a) - at_c).abs() < 1e-13);
        }
        Ok(())
    }
}
