//! Decides how a line gets a thickness: rings carried along it by the rotation-minimising frame.

use super::{Mesh, MeshError, checked_length, checked_point, checked_resolution};
use super::{direction, perpendicular};
use glam::{DQuat, DVec3};
use std::f64::consts::TAU;

/// How the two ends of a line meet.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ends {
    /// The last point is joined to the first.
    Closed,
    /// Each end is covered by a flat cap.
    Capped,
}

/// A sharp bend is widened by at most this factor, so that a hairpin does not grow a spike.
const LARGEST_MITRE: f64 = 2.0;

/// A round tube of the given radius along a polyline, in `segments` strips.
///
/// The frame is carried from point to point by the double reflection method, which turns about the
/// line as little as possible (Wang, Jüttler, Zheng, Liu, “Computation of rotation minimizing
/// frames”, ACM Trans. Graph. 27(1), 2008); on a closed line the angle that is left over is spread
/// evenly. At a corner the ring lies in the bisecting plane and is widened there, which keeps the
/// thickness of the straight parts. Points that repeat their predecessor are left out.
///
/// ```
/// use ga_design::mesh::{Ends, tube};
/// let square = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
/// let ring = tube(&square, Ends::Closed, 0.05, 8)?;
/// assert_eq!(ring.triangles().len(), 4 * 8 * 2);
/// # Ok::<(), ga_design::mesh::MeshError>(())
/// ```
///
/// # Errors
/// [`MeshError`] if a coordinate is not finite, the radius is not positive, fewer than two points
/// differ (three for a closed line), or `segments` is not from 3 to 256.
pub fn tube(
    points: &[[f64; 3]],
    ends: Ends,
    radius: f64,
    segments: usize,
) -> Result<Mesh, MeshError> {
    checked_length("the radius of a tube", radius)?;
    checked_resolution("the number of segments of a tube", segments, 3, 256)?;
    let line = distinct(points, ends)?;
    let rings = rings(&line, ends);
    let mut surface = Surface::default();
    for ring in &rings {
        for j in 0..segments {
            let (sine, cosine) = (TAU * j as f64 / segments as f64).sin_cos();
            let normal = ring.across * cosine + ring.up * sine;
            surface.push(ring.centre + ring.mitred(normal) * radius, normal);
        }
    }
    let around = segments as u32;
    let count = rings.len() as u32;
    let steps = if ends == Ends::Closed {
        count
    } else {
        count - 1
    };
    for i in 0..steps {
        for j in 0..around {
            let [here, next] = [i * around, (i + 1) % count * around];
            let [a, b] = [j, (j + 1) % around];
            surface.triangles.push([here + a, here + b, next + b]);
            surface.triangles.push([here + a, next + b, next + a]);
        }
    }
    if let (Ends::Capped, Some(first), Some(last)) = (ends, rings.first(), rings.last()) {
        surface.cap(first, -first.along, radius, around);
        surface.cap(last, last.along, radius, around);
    }
    Mesh::new(surface.positions, surface.normals, surface.triangles)
}

/// The points without repetitions, if enough remain.
fn distinct(points: &[[f64; 3]], ends: Ends) -> Result<Vec<DVec3>, MeshError> {
    let mut line: Vec<DVec3> = Vec::with_capacity(points.len());
    for &point in points {
        let point = checked_point("a point of a tube", point)?;
        if line.last() != Some(&point) {
            line.push(point);
        }
    }
    if ends == Ends::Closed && line.len() > 1 && line.first() == line.last() {
        line.pop();
    }
    let least = if ends == Ends::Closed { 3 } else { 2 };
    if line.len() < least {
        return Err(MeshError::Degenerate {
            what: "a tube needs at least two different points, a closed one three",
        });
    }
    Ok(line)
}

/// One cross-section of a tube.
struct Ring {
    centre: DVec3,
    along: DVec3,
    across: DVec3,
    up: DVec3,
    bend: DVec3,
    mitre: f64,
}

impl Ring {
    /// The offset from the centre, widened in the direction of the bend.
    fn mitred(&self, offset: DVec3) -> DVec3 {
        offset + self.bend * (offset.dot(self.bend) * (self.mitre - 1.0))
    }
}

fn rings(line: &[DVec3], ends: Ends) -> Vec<Ring> {
    let count = line.len();
    let at = |i: usize| line.get(i % count).copied().unwrap_or_default();
    let leaving: Vec<DVec3> = (0..count)
        .map(|i| direction(at(i + 1) - at(i)).unwrap_or(DVec3::Z))
        .collect();
    let step = |i: usize| leaving.get(i % count).copied().unwrap_or(DVec3::Z);
    let mut rings: Vec<Ring> = Vec::with_capacity(count);
    for i in 0..count {
        let (arriving, leaving) = match ends {
            Ends::Closed => (step(i + count - 1), step(i)),
            Ends::Capped if i == 0 => (step(0), step(0)),
            Ends::Capped if i + 1 == count => (step(i - 1), step(i - 1)),
            Ends::Capped => (step(i - 1), step(i)),
        };
        let centre = at(i);
        // A line that turns back on itself has no bisecting plane: the arriving one is as good.
        let along = (arriving + leaving)
            .try_normalize()
            .filter(|along| along.dot(arriving) > 1e-6)
            .unwrap_or(arriving);
        let across = match rings.last() {
            None => perpendicular(along)[0],
            Some(before) => carried(before, centre, along),
        };
        rings.push(Ring {
            centre,
            along,
            across,
            up: along.cross(across),
            bend: (leaving - arriving).normalize_or_zero(),
            mitre: (1.0 / along.dot(arriving)).clamp(1.0, LARGEST_MITRE),
        });
    }
    if ends == Ends::Closed {
        spread_closing_angle(&mut rings);
    }
    rings
}

/// The frame's first vector at the next ring: two reflections, one that moves the centre there and
/// one that corrects the direction of the line.
fn carried(before: &Ring, centre: DVec3, along: DVec3) -> DVec3 {
    let reflect = |vector: DVec3, mirror: Option<DVec3>| match mirror {
        Some(normal) => vector - 2.0 * vector.dot(normal) * normal,
        None => vector,
    };
    let first = direction(centre - before.centre);
    let [across, carried] = [before.across, before.along].map(|v| reflect(v, first));
    let across = reflect(across, direction(along - carried));
    // Rounding is removed at each step, so that a long line stays round.
    direction(across - along * across.dot(along)).unwrap_or(perpendicular(along)[0])
}

fn spread_closing_angle(rings: &mut [Ring]) {
    let (Some(first), Some(last)) = (rings.first(), rings.last()) else {
        return;
    };
    let arrived = carried(last, first.centre, first.along);
    let angle = first.up.dot(arrived).atan2(first.across.dot(arrived));
    let count = rings.len() as f64;
    for (i, ring) in rings.iter_mut().enumerate() {
        let turn = DQuat::from_axis_angle(ring.along, -angle * i as f64 / count);
        ring.across = turn * ring.across;
        ring.up = turn * ring.up;
    }
}

#[derive(Default)]
struct Surface {
    positions: Vec<[f64; 3]>,
    normals: Vec<[f64; 3]>,
    triangles: Vec<[u32; 3]>,
}

impl Surface {
    fn push(&mut self, position: DVec3, normal: DVec3) {
        self.positions.push(position.to_array());
        self.normals.push(normal.to_array());
    }

    /// A flat cap with vertices of its own, so that its rim is sharp.
    fn cap(&mut self, ring: &Ring, normal: DVec3, radius: f64, around: u32) {
        let centre = self.positions.len() as u32;
        self.push(ring.centre, normal);
        for j in 0..around {
            let (sine, cosine) = (TAU * f64::from(j) / f64::from(around)).sin_cos();
            let offset = ring.across * cosine + ring.up * sine;
            self.push(ring.centre + offset * radius, normal);
        }
        let outward = normal.dot(ring.along) > 0.0;
        for j in 0..around {
            let [a, b] = [centre + 1 + j, centre + 1 + (j + 1) % around];
            let triangle = if outward {
                [centre, a, b]
            } else {
                [centre, b, a]
            };
            self.triangles.push(triangle);
        }
    }
}
