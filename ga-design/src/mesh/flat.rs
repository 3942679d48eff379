//! Decides how flat pieces are triangulated: a disc for a circle's inside, a parallelogram for a plane.

use super::{Mesh, MeshError, checked_length, checked_point, checked_resolution};
use super::{direction, perpendicular};
use std::f64::consts::TAU;

/// The disc with this centre, normal and radius. It has one side; materials are drawn on both.
///
/// # Errors
/// [`MeshError`] if a number is not finite, the normal is zero, the radius is not positive, or
/// `segments` is not from 3 to 4096.
pub fn disc(
    centre: [f64; 3],
    normal: [f64; 3],
    radius: f64,
    segments: usize,
) -> Result<Mesh, MeshError> {
    let middle = checked_point("the centre of a disc", centre)?;
    let normal =
        direction(checked_point("the normal of a disc", normal)?).ok_or(MeshError::Degenerate {
            what: "the normal of a disc is zero: give the direction of its axis",
        })?;
    checked_length("the radius of a disc", radius)?;
    checked_resolution("the number of segments of a disc", segments, 3, 4096)?;
    let [first, second] = perpendicular(normal);
    let around = segments as u32;
    let mut positions = vec![centre];
    let mut triangles = Vec::with_capacity(segments);
    for j in 0..around {
        let (sine, cosine) = (TAU * f64::from(j) / f64::from(around)).sin_cos();
        positions.push((middle + (first * cosine + second * sine) * radius).to_array());
        triangles.push([0, 1 + j, 1 + (j + 1) % around]);
    }
    let normals = vec![normal.to_array(); positions.len()];
    Mesh::new(positions, normals, triangles)
}

/// The parallelogram with this centre whose half sides are `u` and `v`; its normal is along u × v.
///
/// ```
/// let plane = ga_design::mesh::parallelogram([0.0; 3], [1.0, 0.0, 0.0], [0.0, 2.0, 0.0])?;
/// assert_eq!(plane.bounds(), [[-1.0, -2.0, 0.0], [1.0, 2.0, 0.0]]);
/// # Ok::<(), ga_design::mesh::MeshError>(())
/// ```
///
/// # Errors
/// [`MeshError`] if a number is not finite or the half sides are parallel.
pub fn parallelogram(centre: [f64; 3], u: [f64; 3], v: [f64; 3]) -> Result<Mesh, MeshError> {
    let centre = checked_point("the centre of a plane", centre)?;
    let u = checked_point("a side of a plane", u)?;
    let v = checked_point("a side of a plane", v)?;
    let parallel = MeshError::Degenerate {
        what: "the sides of a plane are zero or parallel: give two independent directions",
    };
    let [Some(along), Some(across)] = [direction(u), direction(v)] else {
        return Err(parallel);
    };
    let normal = direction(along.cross(across)).ok_or(parallel)?;
    let corners = [-u - v, u - v, u + v, v - u].map(|c| (centre + c).to_array());
    Mesh::new(
        corners.to_vec(),
        vec![normal.to_array(); 4],
        vec![[0, 1, 2], [0, 2, 3]],
    )
}
