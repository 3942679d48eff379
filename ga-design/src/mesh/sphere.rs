//! Decides how spheres are triangulated: by subdividing an icosahedron, or by latitude and longitude.

use super::{Mesh, MeshError, checked_resolution};
use glam::DVec3;
use std::collections::HashMap;
use std::f64::consts::{PI, TAU};

/// The unit sphere as an icosahedron of which every edge is halved `subdivisions` times and moved
/// out to the sphere: 20·4ⁿ nearly equal triangles on 10·4ⁿ + 2 shared vertices.
///
/// ```
/// let sphere = ga_design::mesh::icosphere(2)?;
/// assert_eq!(sphere.triangles().len(), 320);
/// assert_eq!(sphere.positions().len(), 162);
/// # Ok::<(), ga_design::mesh::MeshError>(())
/// ```
///
/// # Errors
/// [`MeshError::Resolution`] above seven subdivisions (327,680 triangles).
pub fn icosphere(subdivisions: usize) -> Result<Mesh, MeshError> {
    checked_resolution("the number of subdivisions", subdivisions, 0, 7)?;
    let mut vertices = icosahedron_vertices();
    let mut triangles = ICOSAHEDRON.to_vec();
    for _ in 0..subdivisions {
        let mut middles = HashMap::new();
        triangles = triangles
            .iter()
            .flat_map(|&[a, b, c]| {
                let [ab, bc, ca] =
                    [[a, b], [b, c], [c, a]].map(|edge| middle(&mut vertices, &mut middles, edge));
                [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]
            })
            .collect();
    }
    let positions: Vec<_> = vertices.iter().map(DVec3::to_array).collect();
    Mesh::new(positions.clone(), positions, triangles)
}

/// The vertices are the corners of three golden rectangles at right angles.
fn icosahedron_vertices() -> Vec<DVec3> {
    let golden = (1.0 + 5.0_f64.sqrt()) / 2.0;
    let mut vertices = Vec::with_capacity(12);
    for [long, short] in [
        [golden, 1.0],
        [golden, -1.0],
        [-golden, 1.0],
        [-golden, -1.0],
    ] {
        for rectangle in [
            DVec3::new(long, short, 0.0),
            DVec3::new(0.0, long, short),
            DVec3::new(short, 0.0, long),
        ] {
            vertices.push(rectangle.normalize());
        }
    }
    vertices
}

/// The faces of [`icosahedron_vertices`], anticlockwise seen from outside.
const ICOSAHEDRON: [[u32; 3]; 20] = [
    [0, 1, 2],
    [0, 4, 1],
    [0, 2, 3],
    [0, 3, 8],
    [0, 8, 4],
    [1, 5, 2],
    [1, 4, 6],
    [1, 6, 5],
    [2, 7, 3],
    [2, 5, 7],
    [3, 7, 10],
    [3, 10, 8],
    [4, 11, 6],
    [4, 8, 11],
    [5, 6, 9],
    [5, 9, 7],
    [6, 11, 9],
    [7, 9, 10],
    [8, 10, 11],
    [9, 11, 10],
];

/// The vertex half-way along an edge, made on first use and shared by both triangles.
fn middle(
    vertices: &mut Vec<DVec3>,
    middles: &mut HashMap<[u32; 2], u32>,
    [a, b]: [u32; 2],
) -> u32 {
    let key = [a.min(b), a.max(b)];
    if let Some(&found) = middles.get(&key) {
        return found;
    }
    let end = |i: u32| vertices.get(i as usize).copied().unwrap_or(DVec3::X);
    let halfway = (end(a) + end(b)).normalize_or(DVec3::X);
    // At most seven subdivisions: 163,842 vertices.
    let index = u32::try_from(vertices.len()).unwrap_or(u32::MAX);
    vertices.push(halfway);
    middles.insert(key, index);
    index
}

/// The unit sphere in `meridians` segments around z and `parallels` bands from pole to pole, with a
/// single vertex at each pole and no seam.
///
/// # Errors
/// [`MeshError::Resolution`] below three meridians or two parallels, or above 1024 of either.
pub fn uv_sphere(meridians: usize, parallels: usize) -> Result<Mesh, MeshError> {
    checked_resolution("the number of meridians", meridians, 3, 1024)?;
    checked_resolution("the number of parallels", parallels, 2, 1024)?;
    let mut positions = vec![[0.0, 0.0, 1.0]];
    for i in 1..parallels {
        let (sine, cosine) = (PI * i as f64 / parallels as f64).sin_cos();
        for j in 0..meridians {
            let (y, x) = (TAU * j as f64 / meridians as f64).sin_cos();
            positions.push([sine * x, sine * y, cosine]);
        }
    }
    positions.push([0.0, 0.0, -1.0]);
    let last = positions.len() as u32 - 1;
    let around = meridians as u32;
    let ring = |i: u32, j: u32| 1 + i * around + j % around;
    let mut triangles = Vec::with_capacity(2 * meridians * (parallels - 1));
    for j in 0..around {
        triangles.push([0, ring(0, j), ring(0, j + 1)]);
        for i in 0..parallels as u32 - 2 {
            let [a, b, c, d] = [
                ring(i, j),
                ring(i, j + 1),
                ring(i + 1, j),
                ring(i + 1, j + 1),
            ];
            triangles.push([a, c, b]);
            triangles.push([b, c, d]);
        }
        let lowest = parallels as u32 - 2;
        triangles.push([last, ring(lowest, j + 1), ring(lowest, j)]);
    }
    Mesh::new(positions.clone(), positions, triangles)
}
