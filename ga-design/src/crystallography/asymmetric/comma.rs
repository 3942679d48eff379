//! The comma: half of the circle that a curved line halves, flat for patterns of the plane and swollen
//! for those of space.

use crate::mesh::{Mesh, MeshError};
use std::f64::consts::{PI, TAU};

/// Steps along the comma, from the tip of its tail to the bottom of its head.
const STEPS: u32 = 40;

/// Points around the swollen comma.
const AROUND: u32 = 20;

/// The height of the flat comma over its radius.
pub const COMMA_THICKNESS: f64 = 0.22;

/// The part of the unit circle that it fills, so that the swollen one with its raised tail fits too.
const SIZE: f64 = 0.88;

/// The points at a part of the way from tail to head: on the outer side, a half circle, and on the inner
/// side, two half circles of half the size.
fn sides(part: f64) -> [[f64; 2]; 2] {
    let (sine, cosine) = (PI * part).sin_cos();
    let outer = [sine, cosine];
    let (turned, along) = (TAU * part).sin_cos();
    let inner = if part < 0.5 {
        [0.5 * turned, 0.5 + 0.5 * along]
    } else {
        // From the middle the other way round: the sine is negative there.
        [0.5 * turned, -0.5 - 0.5 * along]
    };
    [outer, inner].map(|point| point.map(|value| SIZE * value))
}

/// The outline of the comma inside the unit circle, anticlockwise, the tip of its tail first. It has no
/// symmetry in the plane.
///
/// ```
/// use ga_design::crystallography::comma_outline;
///
/// assert!(comma_outline().iter().all(|[x, y]| x * x + y * y <= 1.0));
/// ```
pub fn comma_outline() -> Vec<[f64; 2]> {
    let part = |step: u32| f64::from(step) / f64::from(STEPS);
    let inner = (0..STEPS).map(|step| sides(part(step))[1]);
    let outer = (1..=STEPS).rev().map(|step| sides(part(step))[0]);
    inner.chain(outer).collect()
}

/// The comma as a flat piece of [`COMMA_THICKNESS`], from z = 0 upwards.
///
/// # Errors
/// None.
pub fn flat_comma() -> Result<Mesh, MeshError> {
    let mut faces = Faces::default();
    let outline = comma_outline();
    // Top and bottom, as strips between both sides.
    for (height, up) in [(COMMA_THICKNESS, 1.0), (0.0, -1.0)] {
        let first = faces.count();
        for step in 0..=STEPS {
            for [x, y] in sides(f64::from(step) / f64::from(STEPS)) {
                faces.push([x, y, height], [0.0, 0.0, up]);
            }
        }
        for step in 0..STEPS {
            let [a, b, c, d] = [0, 1, 2, 3].map(|k| first + 2 * step + k);
            if up > 0.0 {
                faces.triangles.extend([[a, b, c], [b, d, c]]);
            } else {
                faces.triangles.extend([[a, c, b], [b, c, d]]);
            }
        }
    }
    // The wall, each piece with its own normal.
    for (at, from) in outline.iter().enumerate() {
        let Some(to) = outline.get((at + 1) % outline.len()) else {
            continue;
        };
        let (dx, dy) = (to[0] - from[0], to[1] - from[1]);
        let length = dx.hypot(dy);
        let outwards = [dy / length, -dx / length, 0.0];
        let first = faces.count();
        for [x, y] in [*from, *to] {
            for height in [0.0, COMMA_THICKNESS] {
                faces.push([x, y, height], outwards);
            }
        }
        let [a, b, c, d] = [0, 1, 2, 3].map(|k| first + k);
        faces.triangles.extend([[a, c, d], [a, d, b]]);
    }
    Mesh::new(faces.positions, faces.normals, faces.triangles)
}

#[derive(Default)]
struct Faces {
    positions: Vec<[f64; 3]>,
    normals: Vec<[f64; 3]>,
    triangles: Vec<[u32; 3]>,
}

impl Faces {
    fn count(&self) -> u32 {
        self.positions.len() as u32
    }

    fn push(&mut self, position: [f64; 3], normal: [f64; 3]) {
        self.positions.push(position);
        self.normals.push(normal);
    }
}

/// How high the comma's middle line is: the tail rises, which takes the mirror of its plane away.
fn rise(part: f64) -> f64 {
    0.5 * (1.0 - part) * (1.0 - part) - 0.14
}

/// The swollen comma: round across, its tail raised.
pub(super) fn solid() -> Result<Mesh, MeshError> {
    let mut positions = Vec::new();
    let mut triangles = Vec::new();
    let [tip, _] = sides(0.0);
    let [bottom, _] = sides(1.0);
    positions.push([tip[0], tip[1], rise(0.0)]);
    for step in 1..STEPS {
        let part = f64::from(step) / f64::from(STEPS);
        let [outer, inner] = sides(part);
        let middle = [0, 1].map(|i| (outer[i] + inner[i]) / 2.0);
        let half = [0, 1].map(|i| (outer[i] - inner[i]) / 2.0);
        let height = half[0].hypot(half[1]) * 0.8;
        for j in 0..AROUND {
            let (sine, cosine) = (TAU * f64::from(j) / f64::from(AROUND)).sin_cos();
            positions.push([
                middle[0] + half[0] * cosine,
                middle[1] + half[1] * cosine,
                rise(part) + height * sine,
            ]);
        }
    }
    let last = positions.len() as u32;
    positions.push([bottom[0], bottom[1], rise(1.0)]);
    let ring = |step: u32, j: u32| 1 + (step - 1) * AROUND + j % AROUND;
    for j in 0..AROUND {
        triangles.push([0, ring(1, j + 1), ring(1, j)]);
        triangles.push([last, ring(STEPS - 1, j), ring(STEPS - 1, j + 1)]);
        for step in 1..STEPS - 1 {
            let [a, b] = [ring(step, j), ring(step, j + 1)];
            let [c, d] = [ring(step + 1, j), ring(step + 1, j + 1)];
            triangles.extend([[a, b, c], [b, d, c]]);
        }
    }
    Mesh::from_triangles(positions, triangles)
}

/// The outline of the swollen comma, raised as it is, closed.
pub(super) fn rim() -> Vec<[f64; 3]> {
    let part = |step: u32| f64::from(step) / f64::from(STEPS);
    let at = |step: u32, side: usize| {
        let [x, y] = sides(part(step))[side];
        [x, y, rise(part(step))]
    };
    let inner = (0..STEPS).map(|step| at(step, 1));
    let outer = (0..=STEPS).rev().map(|step| at(step, 0));
    inner.chain(outer).collect()
}
