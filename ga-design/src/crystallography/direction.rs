//! Along which lattice direction an operation turns or reflects, as whole numbers
//! (where a root lies is a [`RootDirection`](super::RootDirection), of the lattice or its reciprocal).

use super::operation::Operation;

/// A lattice direction, in fractions of the cell edges.
pub type Direction = [i32; 3];

/// The direction of the axis or the normal of the mirror, without a common factor and with a
/// positive first entry; `None` for translations and inversions.
pub fn axis(operation: &Operation) -> Option<Direction> {
    let mut rows = proper(operation);
    for (i, row) in rows.iter_mut().enumerate() {
        row[i] -= 1;
    }
    // The axis is across all rows of W − 1; two independent ones give it.
    [(0, 1), (1, 2), (2, 0)]
        .into_iter()
        .map(|(i, j)| cross(rows[i], rows[j]))
        .find(|direction| *direction != [0; 3])
        .map(|direction| signless(primitive(direction)))
}

/// The rotation of an operation, or minus its rotoinversion.
pub fn proper(operation: &Operation) -> [[i32; 3]; 3] {
    let sign = operation.determinant();
    operation
        .rotation()
        .map(|row| row.map(|entry| sign * entry))
}

/// The order of [`proper`]: 1, 2, 3, 4 or 6 in a crystal; 0 for what belongs to none.
pub fn order(operation: &Operation) -> i32 {
    match operation.determinant() * operation.trace() {
        3 => 1,
        -1 => 2,
        0 => 3,
        1 => 4,
        2 => 6,
        _ => 0,
    }
}

/// The image under a matrix.
pub fn image(w: &[[i32; 3]; 3], v: Direction) -> Direction {
    w.map(|row| row[0] * v[0] + row[1] * v[1] + row[2] * v[2])
}

/// The one of a direction and its opposite whose first entry that is not zero is positive.
pub fn signless(direction: Direction) -> Direction {
    match direction.iter().find(|value| **value != 0) {
        Some(value) if *value < 0 => direction.map(|value| -value),
        _ => direction,
    }
}

fn cross(u: Direction, v: Direction) -> Direction {
    [0, 1, 2].map(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        u[j] * v[k] - u[k] * v[j]
    })
}

fn primitive(direction: Direction) -> Direction {
    let common = direction
        .iter()
        .fold(0, |a: i32, b| greatest_divisor(a, b.abs()));
    direction.map(|value| value / common.max(1))
}

fn greatest_divisor(a: i32, b: i32) -> i32 {
    if b == 0 {
        a
    } else {
        greatest_divisor(b, a % b)
    }
}
