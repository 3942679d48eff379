//! Decides what is told of a point: its place, its symmetry and its orbit.

use super::{Arguments, cell};
use crate::failure::Failure;
use ga_design::crystallography::{Cell, Operation};
use serde::Serialize;

/// Points nearer than this, in ångström or as a part of the shortest edge, are one.
const SAME: f64 = 1e-6;

/// The most powers of an operation of a lattice that differ.
const MOST_POWERS: usize = 12;

/// How near to a special position a point counts as on it if nothing is said, in ångström.
const REACH: f64 = 0.1;

/// A point of a group.
#[derive(Debug, Serialize)]
pub struct Site {
    /// The Wyckoff letter, of a space group.
    pub letter: Option<char>,
    /// The number of points of the orbit per cell.
    pub multiplicity: usize,
    /// The oriented symbol of the site symmetry, of a space group.
    pub site_symmetry: Option<String>,
    /// The order of the site symmetry.
    pub order: usize,
    /// The triplet of the Wyckoff position that the point is on.
    pub coordinates: Option<String>,
    /// The point, on its special position, in fractions of the edges.
    pub place: [f64; 3],
    /// How far that is from the point given, in ångström.
    pub distance: f64,
    /// All points of one cell that the group makes of it.
    pub orbit: Vec<[f64; 3]>,
}

impl Arguments {
    /// The point of `--at`.
    pub fn point(&self) -> Result<Option<[f64; 3]>, Failure> {
        let text = self.at.as_deref();
        text.map(|text| cell::triple("--at", text)).transpose()
    }

    /// The distance of `--snap`; a wrong one finds nothing.
    pub fn reach(&self) -> f64 {
        self.snap.unwrap_or(REACH)
    }

    /// Refuses lengths that are none.
    pub fn check_lengths(&self) -> Result<(), Failure> {
        let wrong = |option: &str, value: f64| {
            Failure::Usage(format!(
                "{option} {value}: give a length in ångström that is not negative"
            ))
        };
        match (self.snap, self.size) {
            (Some(snap), _) if !(0.0..=1e6).contains(&snap) => Err(wrong("--snap", snap)),
            (_, Some(size)) if !(1e-6..=1e6).contains(&size) => Err(wrong("--size", size)),
            _ => Ok(()),
        }
    }
}

/// The place within reach that most operations leave where it is; the point itself where none does.
pub fn snapped(
    operations: &[Operation],
    periodic: [bool; 3],
    cell: &Cell,
    point: [f64; 3],
    reach: f64,
) -> [f64; 3] {
    let near = |operation: &Operation, place: [f64; 3]| {
        let moved = operation.apply(place);
        [0, 1, 2].map(|i| {
            let cells = if periodic[i] {
                (moved[i] - point[i]).round()
            } else {
                0.0
            };
            moved[i] - cells
        })
    };
    let mean = |places: &[[f64; 3]]| {
        let count = places.len().max(1) as f64;
        [0, 1, 2].map(|i| places.iter().map(|place| place[i]).sum::<f64>() / count)
    };
    // The mean of the images under the powers of an operation is what it leaves in place; the mean of
    // all images nearby, where all elements nearby meet.
    let mut candidates = Vec::new();
    let mut all = Vec::new();
    for operation in operations {
        let first = near(operation, point);
        if distance(cell, periodic, point, first) > 2.0 * reach {
            continue;
        }
        all.push(first);
        let mut powers = vec![point];
        let mut next = first;
        while powers.len() < MOST_POWERS && distance(cell, periodic, point, next) > SAME {
            powers.push(next);
            next = near(operation, next);
        }
        candidates.push(mean(&powers));
    }
    candidates.push(mean(&all));
    let fixing = |place: [f64; 3]| {
        let stays = |operation: &&Operation| {
            distance(cell, periodic, place, operation.apply(place)) <= SAME
        };
        operations.iter().filter(stays).count()
    };
    let mut best = (1, point);
    for place in candidates {
        let count = fixing(place);
        if count > best.0 && distance(cell, periodic, point, place) <= reach {
            best = (count, place);
        }
    }
    best.1
}

/// The images of a point in one cell, each once, its own first.
pub fn orbit(
    operations: &[Operation],
    periodic: [bool; 3],
    cell: &Cell,
    place: [f64; 3],
) -> Vec<[f64; 3]> {
    let shortest = cell.edges().into_iter().fold(f64::INFINITY, f64::min);
    let mut found: Vec<[f64; 3]> = Vec::new();
    for operation in operations {
        let image = operation.apply(place);
        let image = [0, 1, 2].map(|i| {
            if periodic[i] {
                reduced(image[i])
            } else {
                image[i]
            }
        });
        let is_new = found
            .iter()
            .all(|known| distance(cell, periodic, *known, image) > SAME * shortest);
        if is_new {
            found.push(image);
        }
    }
    found
}

/// The distance of two points modulo the translations, near enough for small ones.
pub fn distance(cell: &Cell, periodic: [bool; 3], from: [f64; 3], to: [f64; 3]) -> f64 {
    let step = [0, 1, 2].map(|i| {
        let apart = to[i] - from[i];
        if periodic[i] {
            apart - apart.round()
        } else {
            apart
        }
    });
    let [x, y, z] = cell.cartesian(step);
    (x * x + y * y + z * z).sqrt()
}

/// A fraction in the cell, a rounded 1 taken for 0.
fn reduced(value: f64) -> f64 {
    let part = value.rem_euclid(1.0);
    let rounded = (part * 1e12).round() / 1e12;
    if rounded >= 1.0 { 0.0 } else { rounded }
}
