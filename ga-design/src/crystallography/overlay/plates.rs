//! Which symbol stands at the ends of an axis: the lens, triangle, square or hexagon of International
//! Tables as a thin plate across it, with a blade at every corner in the sense of a screw.

use crate::crystallography::symmetry_elements::Axis;
use crate::mesh::{Mesh, MeshError};
use glam::DVec3;
use std::f64::consts::TAU;

/// The thickness of a plate over the radius of its symbol.
const THICKNESS: f64 = 0.22;

/// The plate of an axis along z, of radius 1.
pub(super) fn plate(axis: &Axis) -> Result<Mesh, MeshError> {
    let outline = match axis.rotoinversion().unwrap_or(axis.order()) {
        2 => lens(),
        order => regular(usize::from(order)),
    };
    let mut parts = vec![prism(&outline)?];
    if axis.screw() != 0 && axis.rotoinversion().is_none() {
        let order = usize::from(axis.order());
        // Beyond one half of the order the screw is left-handed.
        let sense = if 2 * axis.screw() <= axis.order() {
            1.0
        } else {
            -1.0
        };
        for corner in 0..order {
            parts.push(prism(&blade(corner, order, sense))?);
        }
    }
    Mesh::joined(&parts)
}

fn ray(angle: f64) -> DVec3 {
    DVec3::new(angle.cos(), angle.sin(), 0.0)
}

/// A regular polygon.
fn regular(corners: usize) -> Vec<DVec3> {
    let step = TAU / corners as f64;
    (0..corners).map(|i| ray(step * i as f64)).collect()
}

/// The lens of a twofold axis: two arcs of circles that meet in its tips.
fn lens() -> Vec<DVec3> {
    let arc = |sign: f64| {
        (0..12).map(move |i| {
            let x = 1.0 - f64::from(i) / 6.0;
            DVec3::new(sign * x, sign * 0.55 * (1.0 - x * x), 0.0)
        })
    };
    arc(1.0).chain(arc(-1.0)).collect()
}

/// The blade at a corner, which trails as a wheel's would that turns in the sense of the screw.
fn blade(corner: usize, order: usize, sense: f64) -> Vec<DVec3> {
    let angle = TAU * corner as f64 / order as f64;
    let (out, around) = (ray(angle), ray(angle + TAU / 4.0) * sense);
    let points = [out * 0.72, out * 1.0, out * 1.05 + around * 0.62];
    // Anticlockwise for either sense.
    let [a, b, c] = points;
    if sense > 0.0 {
        vec![a, b, c]
    } else {
        vec![a, c, b]
    }
}

/// A flat plate with this outline, anticlockwise seen from above and seen whole from its middle.
fn prism(outline: &[DVec3]) -> Result<Mesh, MeshError> {
    let half = DVec3::Z * (THICKNESS / 2.0);
    let middle = outline.iter().sum::<DVec3>() / outline.len().max(1) as f64;
    let (mut positions, mut normals, mut triangles) = (Vec::new(), Vec::new(), Vec::new());
    let mut face = |corners: [DVec3; 3]| {
        let normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
        let normal = crate::mesh::direction(normal).unwrap_or(DVec3::Z);
        let first = u32::try_from(positions.len()).unwrap_or(u32::MAX);
        triangles.push([first, first.saturating_add(1), first.saturating_add(2)]);
        for corner in corners {
            positions.push(corner.to_array());
            normals.push(normal.to_array());
        }
    };
    let next = outline.iter().cycle().skip(1);
    for (&here, &there) in outline.iter().zip(next) {
        face([middle + half, here + half, there + half]);
        face([middle - half, there - half, here - half]);
        face([here - half, there - half, there + half]);
        face([here - half, there + half, here + half]);
    }
    Mesh::new(positions, normals, triangles)
}
