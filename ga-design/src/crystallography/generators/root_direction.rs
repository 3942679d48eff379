//! How it is written along which direction of a lattice a root lies.

use std::fmt;
use std::str::FromStr;

use ga_cga::{Trivector3, Vector3};

use super::super::lattice::reciprocal;

/// Where a root lies in the lattice; the direction counts, not the length.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum RootDirection {
    /// `[uvw]`: along a lattice vector.
    Lattice([i32; 3]),
    /// `(hkl)*`: along a reciprocal vector, perpendicular to a plane of the lattice.
    Reciprocal([i32; 3]),
    /// `-a`: opposite to the first root, as for p = 1.
    OppositeToFirst,
    /// `c^a`: perpendicular to the first and the third root.
    AcrossFirstAndThird,
    /// `-`: no generator uses the root.
    Unused,
}

/// A text that says no direction.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("`{found}` is no direction of a root; one such as `[1-10]`, `(001)*`, `-a`, `c^a` or `-`")]
pub struct DirectionError {
    /// The text.
    pub found: String,
}

/// The three roots of a group in a lattice with these edges; those that are not used are zero.
/// `None` for edges in one plane.
pub(super) fn roots_along(
    directions: [RootDirection; 3],
    edges: &[Vector3; 3],
) -> Option<[Vector3; 3]> {
    let duals = reciprocal(*edges)?;
    let along = |frame: &[Vector3; 3], indices: [i32; 3]| {
        let terms = frame.iter().zip(indices);
        terms.fold(Vector3::default(), |sum, (vector, index)| {
            sum + *vector * f64::from(index)
        })
    };
    let place = |direction: RootDirection| match direction {
        RootDirection::Lattice(indices) => along(edges, indices).normalized(),
        RootDirection::Reciprocal(indices) => along(&duals, indices).normalized(),
        _ => Some(Vector3::default()),
    };
    let [a, b, c] = directions;
    let (first, third) = (place(a)?, place(c)?);
    let second = match b {
        RootDirection::OppositeToFirst => -first,
        RootDirection::AcrossFirstAndThird => {
            let across: Vector3 = (third ^ first) * Trivector3::new(-1.0);
            across.normalized()?
        }
        other => place(other)?,
    };
    Some([first, second, third])
}

impl fmt::Display for RootDirection {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Lattice([u, v, w]) => write!(f, "[{u}{v}{w}]"),
            Self::Reciprocal([h, k, l]) => write!(f, "({h}{k}{l})*"),
            Self::OppositeToFirst => f.write_str("-a"),
            Self::AcrossFirstAndThird => f.write_str("c^a"),
            Self::Unused => f.write_str("-"),
        }
    }
}

impl FromStr for RootDirection {
    type Err = DirectionError;

    fn from_str(text: &str) -> Result<Self, DirectionError> {
        let within = |open, close| {
            let inner = text.strip_prefix(open)?.strip_suffix(close)?;
            indices(inner)
        };
        match text {
            "-a" => Some(Self::OppositeToFirst),
            "c^a" => Some(Self::AcrossFirstAndThird),
            "-" => Some(Self::Unused),
            _ => within("[", "]")
                .map(Self::Lattice)
                .or_else(|| within("(", ")*").map(Self::Reciprocal)),
        }
        .ok_or_else(|| DirectionError {
            found: text.chars().take(40).collect(),
        })
    }
}

/// Three digits, each of which a minus may precede; not all zero.
fn indices(text: &str) -> Option<[i32; 3]> {
    let mut chars = text.chars().peekable();
    let mut found = [0; 3];
    for index in &mut found {
        let sign = if chars.next_if_eq(&'-').is_some() {
            -1
        } else {
            1
        };
        *index = sign * i32::try_from(chars.next()?.to_digit(10)?).ok()?;
    }
    (chars.next().is_none() && found != [0; 3]).then_some(found)
}
