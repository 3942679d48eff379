//! The hand: a right one, its palm towards +z, its fingers along +y and its thumb towards +x: on the right as one looks
//! into the palm.

use super::{ball, ellipsoid};
use crate::mesh::{self, Ends, Mesh, MeshError};

/// The middle line of a finger, from its root to its tip, and its radius.
struct Finger {
    line: [[f64; 3]; 3],
    radius: f64,
}

/// Thumb first; the fingers bend towards the palm.
const FINGERS: [Finger; 5] = [
    finger(
        [[0.26, -0.42, 0.04], [0.55, -0.18, 0.16], [0.62, 0.08, 0.26]],
        0.105,
    ),
    finger(
        [[0.27, 0.0, 0.0], [0.35, 0.42, 0.03], [0.38, 0.68, 0.16]],
        0.085,
    ),
    finger(
        [[0.09, 0.0, 0.0], [0.11, 0.5, 0.03], [0.12, 0.8, 0.18]],
        0.09,
    ),
    finger(
        [[-0.09, 0.0, 0.0], [-0.12, 0.46, 0.03], [-0.14, 0.73, 0.18]],
        0.085,
    ),
    finger(
        [[-0.27, -0.04, 0.0], [-0.34, 0.3, 0.04], [-0.38, 0.5, 0.16]],
        0.075,
    ),
];

const fn finger(line: [[f64; 3]; 3], radius: f64) -> Finger {
    Finger { line, radius }
}

/// The arm as far as it goes.
const WRIST: [[f64; 3]; 2] = [[0.0, -0.4, 0.0], [0.0, -0.93, 0.0]];

pub(super) fn solid() -> Result<Mesh, MeshError> {
    let mut parts = vec![
        ellipsoid([0.0, -0.26, 0.0], [0.4, 0.42, 0.15])?,
        mesh::tube(&WRIST, Ends::Capped, 0.17, 20)?,
    ];
    for finger in &FINGERS {
        parts.push(mesh::tube(&finger.line, Ends::Capped, finger.radius, 14)?);
        for joint in finger.line {
            parts.push(ball(joint, finger.radius)?);
        }
    }
    Mesh::joined(&parts)
}

pub(super) fn strokes() -> Vec<Vec<[f64; 3]>> {
    let fingers = FINGERS.iter().map(|finger| {
        let mut line = vec![WRIST[0]];
        line.extend(finger.line);
        line
    });
    std::iter::once(WRIST.to_vec()).chain(fingers).collect()
}
