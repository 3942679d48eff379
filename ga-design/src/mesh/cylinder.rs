//! Decides how straight solids of revolution are triangulated: cylinder, cone and arrow.

use super::{Ends, Mesh, MeshError, tube};
use super::{checked_length, checked_point, checked_resolution, direction, perpendicular};
use std::f64::consts::TAU;

/// A capped cylinder from one point to another.
///
/// ```
/// let rod = ga_design::mesh::cylinder([0.0; 3], [0.0, 0.0, 2.0], 0.1, 12)?;
/// assert!((rod.bounds()[1][2] - 2.0).abs() < 1e-12);
/// # Ok::<(), ga_design::mesh::MeshError>(())
/// ```
///
/// # Errors
/// [`MeshError`] if a number is not finite, the points coincide, the radius is not positive, or
/// `segments` is not from 3 to 256.
pub fn cylinder(
    from: [f64; 3],
    to: [f64; 3],
    radius: f64,
    segments: usize,
) -> Result<Mesh, MeshError> {
    tube(&[from, to], Ends::Capped, radius, segments)
}

/// A cone with a flat base around `base` and its tip at `tip`.
///
/// # Errors
/// [`MeshError`] as for [`cylinder`].
pub fn cone(
    base: [f64; 3],
    tip: [f64; 3],
    radius: f64,
    segments: usize,
) -> Result<Mesh, MeshError> {
    let base = checked_point("the base of a cone", base)?;
    let tip = checked_point("the tip of a cone", tip)?;
    checked_length("the radius of a cone", radius)?;
    checked_resolution("the number of segments of a cone", segments, 3, 256)?;
    let axis = direction(tip - base).ok_or(MeshError::Degenerate {
        what: "the base and the tip of a cone coincide",
    })?;
    let height = (tip - base).dot(axis);
    let [first, second] = perpendicular(axis);
    let mut positions = Vec::new();
    let mut normals = Vec::new();
    let mut triangles = Vec::new();
    let mut push = |position: glam::DVec3, normal: glam::DVec3| {
        positions.push(position.to_array());
        normals.push(normal.to_array());
    };
    // The tip is repeated for each strip: it has no single normal.
    for j in 0..segments {
        let ray = |part: f64| {
            let (sine, cosine) = (TAU * part / segments as f64).sin_cos();
            first * cosine + second * sine
        };
        // Perpendicular to the slope, which falls by the height while the radius grows.
        let slanted = |ray| direction(ray * height + axis * radius).unwrap_or(ray);
        let [left, right] = [ray(j as f64), ray((j + 1) as f64)];
        push(base + left * radius, slanted(left));
        push(base + right * radius, slanted(right));
        push(tip, slanted(ray(j as f64 + 0.5)));
        push(base + left * radius, -axis);
        push(base + right * radius, -axis);
        push(base, -axis);
        let start = 6 * j as u32;
        triangles.push([start, start + 1, start + 2]);
        triangles.push([start + 4, start + 3, start + 5]);
    }
    Mesh::new(positions, normals, triangles)
}

/// An arrow: a rod of the given radius with a cone of 2.6 times that radius as its head. The head
/// takes 6.5 radii of the length, or 45 % of a short arrow.
///
/// # Errors
/// [`MeshError`] as for [`cylinder`].
pub fn arrow(
    from: [f64; 3],
    to: [f64; 3],
    radius: f64,
    segments: usize,
) -> Result<Mesh, MeshError> {
    let [start, end] = [from, to].map(glam::DVec3::from);
    checked_point("the tail of an arrow", from)?;
    checked_point("the head of an arrow", to)?;
    checked_length("the radius of an arrow", radius)?;
    let part = (6.5 * radius / (end - start).length().max(f64::MIN_POSITIVE)).min(0.45);
    let neck = end.lerp(start, part).to_array();
    Mesh::joined(&[
        tube(&[from, neck], Ends::Capped, radius, segments)?,
        cone(neck, to, 2.6 * radius, segments)?,
    ])
}
