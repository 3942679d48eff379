//! Decides how the outline of a box or of a crystal's cell is drawn: twelve thin rods and round corners.

use super::{Ends, Mesh, MeshError, checked_length, checked_point, icosphere, tube};
use glam::DVec3;

/// The twelve edges of the parallelepiped with one corner at `origin` and the edge vectors a, b, c,
/// each as a pair of corners.
///
/// ```
/// let edges = ga_design::mesh::cell_edges(
///     [0.0; 3],
///     [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
/// );
/// assert_eq!(edges.len(), 12);
/// assert!(edges.contains(&[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0]]));
/// ```
#[must_use]
pub fn cell_edges(origin: [f64; 3], edges: [[f64; 3]; 3]) -> Vec<[[f64; 3]; 2]> {
    let origin = DVec3::from(origin);
    let [a, b, c] = edges.map(DVec3::from);
    [[a, b, c], [b, c, a], [c, a, b]]
        .iter()
        .flat_map(|&[along, side, up]| {
            [DVec3::ZERO, side, up, side + up].map(|corner| {
                let from = origin + corner;
                [from.to_array(), (from + along).to_array()]
            })
        })
        .collect()
}

/// The twelve edges of [`cell_edges`] as rods of the given radius, rounded at the eight corners.
///
/// # Errors
/// [`MeshError`] if a number is not finite, an edge has no length, or the radius is not positive.
pub fn box_edges(
    origin: [f64; 3],
    edges: [[f64; 3]; 3],
    radius: f64,
    segments: usize,
) -> Result<Mesh, MeshError> {
    checked_point("the corner of a box", origin)?;
    for edge in edges {
        checked_point("the edge of a box", edge)?;
    }
    checked_length("the radius of a box's edges", radius)?;
    let rods = cell_edges(origin, edges);
    let mut parts = Vec::with_capacity(20);
    for rod in &rods {
        parts.push(tube(rod, Ends::Capped, radius, segments)?);
    }
    let [a, b, c] = edges.map(DVec3::from);
    let ball = icosphere(1)?;
    for corner in 0..8_u8 {
        let mut centre = DVec3::from(origin);
        for (bit, edge) in [a, b, c].into_iter().enumerate() {
            if corner >> bit & 1 == 1 {
                centre += edge;
            }
        }
        let placed = ball
            .positions()
            .iter()
            .map(|&p| (centre + DVec3::from(p) * radius).to_array())
            .collect();
        parts.push(Mesh::new(
            placed,
            ball.normals().to_vec(),
            ball.triangles().to_vec(),
        )?);
    }
    Mesh::joined(&parts)
}
