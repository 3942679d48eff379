//! What one rotation of a Hall symbol means: its matrix, its axis when none is written, its
//! translation.

use super::super::operation::{DENOMINATOR, Operation};
use super::{HallError, shown};

type Matrix = [[i32; 3]; 3];

/// The direction of a rotation axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    /// One of the cell edges: 0, 1, 2 for x, y, z.
    Edge(usize),
    /// `'`: the difference of the two edges after the given one.
    Difference(usize),
    /// `"`: the sum of the two edges after the given one.
    Sum(usize),
    /// `*`: the body diagonal.
    Diagonal,
    /// None, for the identity and the inversion.
    Absent,
}

/// A rotation of a Hall symbol.
#[derive(Clone, Copy, Debug)]
pub struct Rotation {
    improper: bool,
    order: u8,
    axis: Axis,
    /// In units of one over [`DENOMINATOR`].
    translation: [i32; 3],
    matrix: Matrix,
}

impl Rotation {
    /// Reads the rotation that begins at `at`; `place` counts from 0, `before` is the one before.
    pub fn read(
        bytes: &[u8],
        at: &mut usize,
        place: usize,
        before: Option<&Self>,
    ) -> Result<Self, HallError> {
        let column = *at + 1;
        let improper = bytes.get(*at) == Some(&b'-');
        if improper {
            *at += 1;
        }
        let order = match bytes.get(*at) {
            Some(digit @ (b'1' | b'2' | b'3' | b'4' | b'6')) => digit - b'0',
            other => {
                let found = shown(other.copied());
                return Err(HallError::Unexpected {
                    found,
                    column: *at + 1,
                });
            }
        };
        *at += 1;
        let screw = match bytes.get(*at) {
            Some(digit @ b'1'..=b'5') if digit - b'0' < order => {
                *at += 1;
                i32::from(digit - b'0')
            }
            _ => 0,
        };
        let mut axis = None;
        let mut translation = [0; 3];
        while let Some(letter) = bytes.get(*at).map(u8::to_ascii_lowercase) {
            if letter.is_ascii_whitespace() || letter == b'_' {
                break;
            }
            if let (None, Some(written)) = (axis, written_axis(letter, before)) {
                axis = Some(written);
            } else if let Some(part) = translation_of(letter) {
                for (sum, value) in translation.iter_mut().zip(part) {
                    *sum += value;
                }
            } else {
                return Err(HallError::Unexpected {
                    found: shown(Some(letter)),
                    column: *at + 1,
                });
            }
            *at += 1;
        }
        let axis = axis.or_else(|| implied_axis(order, place, before));
        let axis = axis.ok_or(HallError::Axis { column })?;
        let matrix = matrix(order, axis).ok_or(HallError::Axis { column })?;
        if screw > 0 {
            let Axis::Edge(edge) = axis else {
                return Err(HallError::Axis { column });
            };
            translation[edge] += DENOMINATOR * screw / i32::from(order);
        }
        Ok(Self {
            improper,
            order,
            axis,
            translation,
            matrix,
        })
    }

    /// The operation; always present for a rotation that was read.
    pub fn operation(&self) -> Option<Operation> {
        let sign = if self.improper { -1 } else { 1 };
        let matrix = self.matrix.map(|row| row.map(|entry| sign * entry));
        Operation::from_units(matrix, self.translation)
    }
}

/// The inversion at the origin.
pub fn inversion() -> Option<Operation> {
    Operation::from_units([[-1, 0, 0], [0, -1, 0], [0, 0, -1]], [0; 3])
}

fn written_axis(letter: u8, before: Option<&Rotation>) -> Option<Axis> {
    // The diagonals lie in the plane across the axis of the rotation before.
    let principal = match before.map(|rotation| rotation.axis) {
        Some(Axis::Edge(edge)) => edge,
        _ => 2,
    };
    match letter {
        b'x' => Some(Axis::Edge(0)),
        b'y' => Some(Axis::Edge(1)),
        b'z' => Some(Axis::Edge(2)),
        b'\'' | b'^' => Some(Axis::Difference(principal)),
        b'"' | b'=' => Some(Axis::Sum(principal)),
        b'*' => Some(Axis::Diagonal),
        _ => None,
    }
}

fn implied_axis(order: u8, place: usize, before: Option<&Rotation>) -> Option<Axis> {
    match (order, place, before.map(|rotation| rotation.order)) {
        (1, _, _) => Some(Axis::Absent),
        (_, 0, _) => Some(Axis::Edge(2)),
        (2, 1, Some(2 | 4)) => Some(Axis::Edge(0)),
        (2, 1, Some(3 | 6)) => Some(Axis::Difference(2)),
        (3, _, _) => Some(Axis::Diagonal),
        _ => None,
    }
}

/// In units of one over [`DENOMINATOR`].
fn translation_of(letter: u8) -> Option<[i32; 3]> {
    const HALF: i32 = DENOMINATOR / 2;
    const QUARTER: i32 = DENOMINATOR / 4;
    Some(match letter {
        b'a' => [HALF, 0, 0],
        b'b' => [0, HALF, 0],
        b'c' => [0, 0, HALF],
        b'n' => [HALF, HALF, HALF],
        b'u' => [QUARTER, 0, 0],
        b'v' => [0, QUARTER, 0],
        b'w' => [0, 0, QUARTER],
        b'd' => [QUARTER, QUARTER, QUARTER],
        _ => return None,
    })
}

/// The proper rotation; Hall's tables 3 and 4.
fn matrix(order: u8, axis: Axis) -> Option<Matrix> {
    let identity = Operation::IDENTITY.rotation();
    match (order, axis) {
        (1, _) => Some(identity),
        (2, Axis::Difference(edge)) => Some(about(edge, [[0, -1], [-1, 0]], -1)),
        (2, Axis::Sum(edge)) => Some(about(edge, [[0, 1], [1, 0]], -1)),
        (3, Axis::Diagonal) => Some([[0, 0, 1], [1, 0, 0], [0, 1, 0]]),
        (2, Axis::Edge(edge)) => Some(about(edge, [[-1, 0], [0, -1]], 1)),
        (3, Axis::Edge(edge)) => Some(about(edge, [[0, -1], [1, -1]], 1)),
        (4, Axis::Edge(edge)) => Some(about(edge, [[0, -1], [1, 0]], 1)),
        (6, Axis::Edge(edge)) => Some(about(edge, [[1, -1], [1, 0]], 1)),
        _ => None,
    }
}

/// `plane` acts on the two edges that follow `edge` in cyclic order, `along` on `edge` itself.
fn about(edge: usize, plane: [[i32; 2]; 2], along: i32) -> Matrix {
    let (first, second) = ((edge + 1) % 3, (edge + 2) % 3);
    let mut matrix = [[0; 3]; 3];
    matrix[edge][edge] = along;
    matrix[first][first] = plane[0][0];
    matrix[first][second] = plane[0][1];
    matrix[second][first] = plane[1][0];
    matrix[second][second] = plane[1][1];
    matrix
}
