//! Spheres and cylinders warped by point pairs that a group has made symmetric (3.9, figure 3.7).

use super::GalleryError;
use super::palette::{BLUE, ORANGE, TEAL, YELLOW, solid};
use crate::crystallography::PointGroup;
use crate::export::{Scene, View};
use crate::mesh::{self, Mesh};
use crate::warp::{Warp, Weighting};
use ga_cga::{Point, PointPair, Vector3};
use std::f64::consts::TAU;

/// What is warped.
#[derive(Debug, Clone, Copy)]
enum Blank {
    Sphere,
    /// A cylinder of radius one and this half of a height.
    Cylinder(f64),
}

/// A shape, and the pair and the group that warp it.
struct Example {
    name: &'static str,
    color: [u8; 3],
    blank: Blank,
    /// The geometric symbol of the group.
    group: &'static str,
    /// The centre, the direction and the squared radius of the pair.
    pair: ([f64; 3], [f64; 3], f64),
    weighting: Weighting,
    amount: f64,
}

const fn near(reach: f64) -> Weighting {
    Weighting::Near { reach }
}

/// Spheres above, cylinders below.
const EXAMPLES: [[Example; 4]; 2] = [
    [
        Example {
            name: "star",
            color: ORANGE,
            blank: Blank::Sphere,
            group: "43",
            pair: ([0.577; 3], [0.577; 3], 0.0),
            weighting: near(0.5),
            amount: 0.8,
        },
        Example {
            name: "flower",
            color: YELLOW,
            blank: Blank::Sphere,
            group: "43",
            pair: ([0.65; 3], [1.0; 3], -0.2),
            weighting: near(0.35),
            amount: -0.6,
        },
        Example {
            name: "buds",
            color: TEAL,
            blank: Blank::Sphere,
            group: "53",
            pair: ([1.2, 0.0, 0.0], [1.0, 0.0, 0.0], -0.1),
            weighting: near(0.3),
            amount: -0.8,
        },
        Example {
            name: "propeller",
            color: BLUE,
            blank: Blank::Sphere,
            group: "b(3)b(2)",
            pair: ([0.9, 0.0, 0.4], [0.6, 0.7, 0.7], -0.4),
            weighting: near(0.6),
            amount: -1.2,
        },
    ],
    [
        Example {
            name: "gear",
            color: BLUE,
            blank: Blank::Cylinder(0.2),
            group: "b(7)b(2)",
            pair: ([0.9, 0.0, 0.0], [0.0, 1.0, 0.8], -0.1),
            weighting: near(0.3),
            amount: 1.2,
        },
        Example {
            name: "lantern",
            color: TEAL,
            blank: Blank::Cylinder(1.0),
            group: "b(6)2",
            pair: ([1.2, 0.0, 0.5], [1.0, 0.0, 1.0], 0.0),
            weighting: near(0.5),
            amount: -0.8,
        },
        Example {
            name: "spindle",
            color: YELLOW,
            blank: Blank::Cylinder(1.0),
            group: "b(3)b(2)",
            pair: ([0.3, 0.6, 0.5], [0.6, 0.3, 0.6], 0.0),
            weighting: Weighting::SquaredDistance,
            amount: 0.12,
        },
        Example {
            name: "column",
            color: ORANGE,
            blank: Blank::Cylinder(1.2),
            group: "b(4)b(2)",
            pair: ([1.0, 0.0, 0.6], [0.0, 1.0, 1.0], -0.2),
            weighting: near(0.5),
            amount: 1.0,
        },
    ],
];

/// The distance between the middles of neighbours, which are two wide.
const APART: f64 = 2.5;

impl Example {
    fn warp(&self) -> Result<Warp, GalleryError> {
        let group = PointGroup::from_geometric(self.group)?;
        let (at, along, square) = self.pair;
        let center = Point::from(Vector3::from(at));
        let pair = PointPair::about(center, square, Vector3::from(along));
        let transformations = group.transformations();
        Ok(Warp::generated(
            transformations,
            &[pair],
            self.weighting,
            self.amount,
        )?)
    }

    fn blank(&self) -> Result<Mesh, GalleryError> {
        Ok(match self.blank {
            Blank::Sphere => mesh::icosphere(5)?,
            Blank::Cylinder(half) => cylinder(half)?,
        })
    }

    /// The warped shape, two wide, with its middle here.
    fn standing(&self, at: [f64; 3]) -> Result<Mesh, GalleryError> {
        let warped = self.warp()?.mesh(&self.blank()?)?;
        let [least, greatest] = warped.bounds();
        let widths = least.iter().zip(greatest).map(|(low, high)| high - low);
        let scale = 2.0 / widths.fold(f64::MIN_POSITIVE, f64::max);
        let place = |p: &[f64; 3]| {
            std::array::from_fn(|i| at[i] + scale * (p[i] - least[i].midpoint(greatest[i])))
        };
        Ok(Mesh::new(
            warped.positions().iter().map(place).collect(),
            warped.normals().to_vec(),
            warped.triangles().to_vec(),
        )?)
    }
}

/// A cylinder of radius one from −half to half, whose flat ends are as fine as its side, so that they warp
/// as smoothly.
fn cylinder(half: f64) -> Result<Mesh, GalleryError> {
    const AROUND: u32 = 144;
    const STEPS: u32 = 32;
    // Where each part of the profile begins and ends, as radius and height, and its normal.
    let parts = [
        ([0.0, -half], [1.0, -half], [0.0, -1.0]),
        ([1.0, -half], [1.0, half], [1.0, 0.0]),
        ([1.0, half], [0.0, half], [0.0, 1.0]),
    ];
    let (mut positions, mut normals, mut triangles) = (Vec::new(), Vec::new(), Vec::new());
    for (from, to, normal) in parts {
        for step in 0..=STEPS {
            let part = f64::from(step) / f64::from(STEPS);
            let [radius, height] = [0, 1].map(|i| from[i] + (to[i] - from[i]) * part);
            let below = positions.len() as u32;
            for j in 0..AROUND {
                let (sine, cosine) = (TAU * f64::from(j) / f64::from(AROUND)).sin_cos();
                positions.push([radius * cosine, radius * sine, height]);
                normals.push([normal[0] * cosine, normal[0] * sine, normal[1]]);
                if step > 0 {
                    let [here, next] = [j, (j + 1) % AROUND].map(|j| below - AROUND + j);
                    // On the axis one of the two triangles of a step has no width.
                    if step > 1 || from[0] > 0.0 {
                        triangles.push([here, next, next + AROUND]);
                    }
                    if radius > 0.0 {
                        triangles.push([here, next + AROUND, here + AROUND]);
                    }
                }
            }
        }
    }
    Ok(Mesh::new(positions, normals, triangles)?)
}

pub(super) fn scene() -> Result<Scene, GalleryError> {
    let mut scene = Scene::new(
        "balanced-shapes",
        "Balanced shapes",
        "Spheres above and cylinders below, each warped by a single point pair and its images under a \
         point group: every point is moved by the exponential of their sum, in which a pair counts the \
         more the nearer it is; for the yellow spindle the farther, as (3.9) is printed. The shapes have \
         the symmetry of their groups: 43, 43, 53 and 3̄2̄, then 7̄2̄, 6̄2, 3̄2̄ and 4̄2̄.",
    );
    for (row, examples) in EXAMPLES.iter().enumerate() {
        for (column, example) in examples.iter().enumerate() {
            let at = [APART * column as f64, 0.0, -APART * row as f64];
            let material = scene.add_material(solid(example.name, example.color)?);
            scene.add(example.name, example.standing(at)?, material)?;
        }
    }
    scene.set_view(View {
        azimuth: -1.42,
        elevation: 0.36,
    })?;
    Ok(scene)
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    #[test]
    fn the_cylinder_is_closed_and_looks_outwards() -> Result<(), GalleryError> {
        let cylinder = cylinder(0.7)?;
        let mut volume = 0.0;
        for triangle in cylinder.triangles() {
            let [a, b, c] = triangle.map(|i| DVec3::from(cylinder.positions()[i as usize]));
            let normal = DVec3::from(cylinder.normals()[triangle[0] as usize]);
            let face = (b - a).cross(c - a);
            assert!(face.dot(normal) > 0.0);
            volume += a.dot(b.cross(c)) / 6.0;
        }
        // The prism of 144 sides that is inscribed in it.
        let expected = 1.4 * 72.0 * (TAU / 144.0).sin();
        assert!((volume - expected).abs() < 1e-9, "{volume}");
        Ok(())
    }

    #[test]
    fn the_warps_commute_with_their_groups() -> Result<(), GalleryError> {
        for example in EXAMPLES.iter().flatten() {
            let (warp, group) = (example.warp()?, PointGroup::from_geometric(example.group)?);
            let point = Point::at(0.6, 0.48, 0.64);
            let Some(image) = warp.apply(point) else {
                return Err(GalleryError::Degenerate { what: "an image" });
            };
            for isometry in group.transformations() {
                let first = warp.apply(isometry.apply(point));
                let apart = first.map(|first| first.distance(isometry.apply(image)));
                assert!(
                    apart.is_some_and(|apart| apart < 1e-12),
                    "{} {apart:?}",
                    example.name
                );
            }
        }
        Ok(())
    }
}
