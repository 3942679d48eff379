//! What one operation leaves in place, and what it moves along it: location part and intrinsic part
//! (H. Wondratschek and J. Neubüser, *Acta Cryst.* 23 (1967) 349–352), exactly.
//!
//! In coordinates with the axis as third basis vector, `U d = (0, 0, 1)`, the matrix of a rotation or
//! rotoinversion is
//! ```text
//!        ⎡ A  0 ⎤      A: 2 × 2, A − 1 invertible
//! W' =   ⎣ r ±1 ⎦      w' = U w
//! ```
//! so that the axis is where `(A − 1)(α, β) = −(w'₁, w'₂)`, and `r·(α, β) + w'₃` is the screw
//! translation along it (or, for −1, twice the height of the inversion point). With all lattice
//! translations the right side runs over whole vectors modulo `A − 1`: det(A − 1) ≤ 4 axes.
//! In a mirror or glide plane `h·x = h·w/2`, and the glide is the half of `w + W w`.

use super::Fraction;
use super::lattice_basis::{LatticeBasis, dot, image, modulo_one, primitive};
use super::place::{LatticeLine, LatticePlane, matrix, translation};
use crate::crystallography::Operation;

/// What an operation, followed by all lattice translations, does in space; elements modulo the lattice.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Part {
    /// A lattice or centring translation.
    Translation,
    /// Inversion in each of these points.
    Inversion(Vec<[Fraction; 3]>),
    /// Reflection in each of these planes, then the glide.
    Reflection(Vec<(LatticePlane, [Fraction; 3])>),
    /// Rotations about each of these lines, or rotoinversions.
    Turn {
        /// 2, 3, 4 or 6; 3, 4 or 6 for `-3`, `-4`, `-6`.
        order: u8,
        /// Whether it is a rotation without inversion.
        is_proper: bool,
        /// The axes; with a rotation the translation along each, of that sense which is anticlockwise
        /// seen against the direction; with a rotoinversion the height of its point over that of the
        /// line. Both are parts of the direction.
        axes: Vec<(LatticeLine, Fraction)>,
    },
}

impl Part {
    /// The part of an operation; `None` where its matrix is no rotation or rotoinversion of a crystal,
    /// or its axis has indices beyond 64.
    pub(super) fn of(operation: &Operation) -> Option<Self> {
        let (sign, trace) = (operation.determinant(), operation.trace());
        // International Tables A, table 1.2.2.1; the order of −W is that of the rotation part.
        let order = match sign * trace {
            3 => 1,
            -1 => 2,
            0 => 3,
            1 => 4,
            2 => 6,
            _ => return None,
        };
        let w = matrix(operation);
        let rotation = w.map(|row| row.map(|entry| entry * i64::from(sign)));
        if !has_order(&rotation, order) {
            return None;
        }
        match (sign, order) {
            (1, 1) => Some(Self::Translation),
            (_, 1) => Some(Self::Inversion(centres(translation(operation)))),
            (-1, 2) => Some(Self::Reflection(planes(operation, &w)?)),
            _ => Some(Self::Turn {
                order,
                is_proper: sign > 0,
                axes: axes(operation, &rotation, sign)?,
            }),
        }
    }
}

/// Whether the matrix to this power is the identity.
fn has_order(rotation: &[[i64; 3]; 3], order: u8) -> bool {
    let mut power = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
    for _ in 0..order {
        power = super::lattice_basis::product(&power, rotation);
        // A matrix of finite order in a cell as described keeps small entries.
        if power.iter().flatten().any(|entry| entry.abs() > 1 << 20) {
            return false;
        }
    }
    power == [[1, 0, 0], [0, 1, 0], [0, 0, 1]]
}

/// The eight points that are inverted into a point that a lattice translation away is themselves.
fn centres(w: [Fraction; 3]) -> Vec<[Fraction; 3]> {
    let step = |i: i64, part: Fraction| modulo_one((part + i) / 2);
    let counts = (0..8).map(|corner| [corner >> 2 & 1, corner >> 1 & 1, corner & 1]);
    counts
        .map(|[i, j, k]| [step(i, w[0]), step(j, w[1]), step(k, w[2])])
        .collect()
}

/// The planes of a reflection, and its glides.
fn planes(operation: &Operation, w: &[[i64; 3]; 3]) -> Option<Vec<(LatticePlane, [Fraction; 3])>> {
    // All rows of 1 − W are multiples of the normal.
    let rows = less_identity(w);
    let normal = rows.into_iter().find_map(primitive)?;
    let [_, _, step] = LatticeBasis::completing(normal).forms();
    let shift = translation(operation);
    let planes = [0, 1].map(|times: i64| {
        let shift = [0, 1, 2].map(|i| shift[i] + step[i] * times);
        let back = image(w, shift);
        let glide = [0, 1, 2].map(|i| (shift[i] + back[i]) / 2);
        (LatticePlane::at(normal, dot(normal, shift) / 2), glide)
    });
    Some(planes.to_vec())
}

/// The axes of a rotation, or with a sign of −1 of a rotoinversion, and what the operation does along
/// each.
fn axes(
    operation: &Operation,
    rotation: &[[i64; 3]; 3],
    sign: i32,
) -> Option<Vec<(LatticeLine, Fraction)>> {
    let direction = axis_direction(rotation)?;
    let basis = LatticeBasis::completing(direction);
    let [[a, b, _], [c, d, _], [r, s, _]] = basis.matrix(&matrix(operation));
    let [x, y, z] = basis.coordinates(translation(operation));
    let clockwise = is_clockwise(rotation, direction);
    let determinant = (a - 1) * (d - 1) - b * c;
    // Whole vectors modulo A − 1 are found among the multiples of unit vectors up to det(A − 1).
    let count = determinant.abs();
    if !(1..=4).contains(&count) {
        return None;
    }
    let mut found: Vec<(LatticeLine, Fraction)> = Vec::new();
    for (i, j) in (0..count).flat_map(|i| (0..count).map(move |j| (i, j))) {
        let (x, y) = (x + i, y + j);
        let across = (y * b - x * (d - 1)) / determinant;
        let aside = (x * c - y * (a - 1)) / determinant;
        let along = across * r + aside * s + z;
        let point = basis.point([across, aside, Fraction::from(0)]);
        let line = LatticeLine::reduced(direction, point)?;
        if sign > 0 {
            let along = if clockwise { -along } else { along };
            found.push((line, along));
        } else {
            // A step of one along the axis moves the point by half of it.
            for k in 0..2 {
                found.push((line, modulo_one((along + k) / 2)));
            }
        }
    }
    found.sort();
    found.dedup();
    Some(found)
}

/// The primitive vector that a rotation leaves as it is.
fn axis_direction(rotation: &[[i64; 3]; 3]) -> Option<[i64; 3]> {
    // It is perpendicular to all rows of W − 1, of which two are independent.
    let [p, q, r] = less_identity(rotation);
    let cross = |u: [i64; 3], v: [i64; 3]| {
        [0, 1, 2].map(|i: usize| {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            u[j] * v[k] - u[k] * v[j]
        })
    };
    let pairs = [(p, q), (q, r), (r, p)];
    pairs.into_iter().find_map(|(u, v)| primitive(cross(u, v)))
}

/// Whether a rotation of order 3, 4 or 6 turns clockwise seen against the direction of its axis; the
/// cell edges are right-handed, so that the sign of a determinant of fractions is that of a volume.
fn is_clockwise(rotation: &[[i64; 3]; 3], direction: [i64; 3]) -> bool {
    let volume = |i: usize| {
        // e_i, its image and the axis.
        let image = rotation.map(|row| row[i]);
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        image[j] * direction[k] - image[k] * direction[j]
    };
    [0, 1, 2].into_iter().map(volume).any(|v| v < 0)
}

/// `W − 1`, row by row.
fn less_identity(w: &[[i64; 3]; 3]) -> [[i64; 3]; 3] {
    [0, 1, 2].map(|i| [0, 1, 2].map(|j| w[i][j] - i64::from(i == j)))
}
