//! Decides how a circle in space is drawn: as a torus of which it is the core.

use super::{Mesh, MeshError, checked_length, checked_point, checked_resolution};
use super::{direction, perpendicular};
use std::f64::consts::TAU;

/// A torus around the circle with this centre, normal and radius; `thickness` is the radius of its
/// tube, `around` the number of parts along the circle and `segments` the number about the tube.
///
/// ```
/// let ring = ga_design::mesh::torus([0.0; 3], [0.0, 0.0, 1.0], 2.0, 0.1, 64, 12)?;
/// assert!((ring.bounds()[1][2] - 0.1).abs() < 1e-9);
/// # Ok::<(), ga_design::mesh::MeshError>(())
/// ```
///
/// # Errors
/// [`MeshError`] if a number is not finite, a length is not positive, the normal is zero, or a
/// resolution is not from 3 to 4096 along the circle and 3 to 256 about the tube.
pub fn torus(
    centre: [f64; 3],
    normal: [f64; 3],
    radius: f64,
    thickness: f64,
    around: usize,
    segments: usize,
) -> Result<Mesh, MeshError> {
    let centre = checked_point("the centre of a circle", centre)?;
    let normal = direction(checked_point("the normal of a circle", normal)?).ok_or(
        MeshError::Degenerate {
            what: "the normal of a circle is zero: give the direction of its axis",
        },
    )?;
    checked_length("the radius of a circle", radius)?;
    checked_length("the thickness of a circle", thickness)?;
    checked_resolution("the number of parts of a circle", around, 3, 4096)?;
    checked_resolution("the number of segments of a tube", segments, 3, 256)?;
    let [first, second] = perpendicular(normal);
    let mut positions = Vec::with_capacity(around * segments);
    let mut normals = Vec::with_capacity(around * segments);
    let mut triangles = Vec::with_capacity(2 * around * segments);
    for i in 0..around {
        let (sine, cosine) = (TAU * i as f64 / around as f64).sin_cos();
        let outward = first * cosine + second * sine;
        for j in 0..segments {
            let (sine, cosine) = (TAU * j as f64 / segments as f64).sin_cos();
            let across = outward * cosine + normal * sine;
            positions.push((centre + outward * radius + across * thickness).to_array());
            normals.push(across.to_array());
            let vertex = |i: usize, j: usize| (i % around * segments + j % segments) as u32;
            let [a, b] = [vertex(i, j), vertex(i + 1, j)];
            let [c, d] = [vertex(i, j + 1), vertex(i + 1, j + 1)];
            triangles.push([a, b, d]);
            triangles.push([a, d, c]);
        }
    }
    Mesh::new(positions, normals, triangles)
}
