//! Which symbol an axis has when several operations share it: the highest, as International Tables
//! draw it.

use std::fmt;

use super::lattice_basis::{Fraction, LatticeBasis, modulo_one};
use super::place::LatticeLine;

/// A rotation, screw or rotoinversion axis with all operations that share its line.
///
/// Printed with its symbol in *International Tables* A (table 2.1.2.5 ff.): `2`, `3_1`, `-4`, and
/// `4_2/m` where inversion centres lie on an axis of even order.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Axis {
    pub(super) line: LatticeLine,
    pub(super) order: u8,
    pub(super) screw: u8,
    pub(super) period: Fraction,
    pub(super) rotoinversion: Option<u8>,
    pub(super) has_centre: bool,
    pub(super) inversion_points: Vec<[Fraction; 3]>,
    pub(super) operations: Vec<usize>,
}

impl Axis {
    /// Where it lies, modulo the lattice.
    pub fn line(&self) -> LatticeLine {
        self.line
    }

    /// The largest order of the rotations or screw rotations about it: 2, 3, 4 or 6.
    pub fn order(&self) -> u8 {
        self.order
    }

    /// The subscript `q` of the symbol `n_q`: the screw of one `n`-th of a turn, anticlockwise seen
    /// against any direction along the axis, advances by `q / n` of the shortest lattice translation
    /// in that direction. 0 for a rotation axis.
    ///
    /// `3_1`, `4_1`, `6_1` and `6_2` are right-handed screws; in the mirror they are `3_2`, `4_3`,
    /// `6_5` and `6_4`.
    pub fn screw(&self) -> u8 {
        self.screw
    }

    /// The shortest lattice translation along it, as a part of [`LatticeLine::direction`]: less than 1
    /// where a centring translation lies along the axis.
    pub fn period(&self) -> Fraction {
        self.period
    }

    /// The translation of the screw in fractions of the cell edges; `None` for a rotation axis.
    pub fn screw_vector(&self) -> Option<[Fraction; 3]> {
        let part = self.period * i64::from(self.screw) / i64::from(self.order.max(1));
        (self.screw != 0).then(|| self.line.direction().map(|index| part * index))
    }

    /// 3, 4 or 6 where the symbol is `-3`, `-4` or `-6`.
    pub fn rotoinversion(&self) -> Option<u8> {
        self.rotoinversion
    }

    /// Whether inversion centres lie on it.
    pub fn has_inversion_centre(&self) -> bool {
        self.has_centre
    }

    /// The points of the axis that its rotoinversions leave in place, in one cell: inversion centres
    /// for `-3`, the points at the heart of `-4` and `-6`, and those of the rotoinversions that `4/m`,
    /// `6/m` and their screws contain.
    pub fn inversion_points(&self) -> &[[Fraction; 3]] {
        &self.inversion_points
    }

    /// The positions, in the list of operations, of those that it is the element of.
    pub fn operations(&self) -> &[usize] {
        &self.operations
    }
}

impl fmt::Display for Axis {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(order) = self.rotoinversion {
            return write!(f, "-{order}");
        }
        write!(f, "{}", self.order)?;
        if self.screw != 0 {
            write!(f, "_{}", self.screw)?;
        }
        if self.has_centre {
            write!(f, "/m")?;
        }
        Ok(())
    }
}

/// A rotation about a line, or a rotation with inversion in a point of it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Turn {
    pub(super) operation: usize,
    pub(super) order: u8,
    /// The screw translation, or the height of the inversion point, as a part of the direction.
    pub(super) along: Fraction,
    pub(super) is_proper: bool,
}

/// The axis of all turns about one line; `None` where no proper rotation is among them, which happens
/// only to lists of operations that are no group.
pub(super) fn merged(
    line: LatticeLine,
    turns: &[Turn],
    centrings: &[[Fraction; 3]],
    centres: &[[Fraction; 3]],
) -> Option<Axis> {
    let period = period(line.direction(), centrings);
    let highest = turns.iter().filter(|turn| turn.is_proper);
    let highest = highest.max_by_key(|turn| turn.order)?;
    // n turns of the screw make a lattice translation along the axis, so that this is whole.
    let turned = modulo_one(highest.along / period) * i64::from(highest.order);
    let screw = u8::try_from(turned.round().to_integer()).ok()? % highest.order;
    let improper = turns.iter().filter(|turn| !turn.is_proper);
    let has_centre = centres.iter().any(|centre| line.contains(*centre));
    let rotoinversion = match (highest.order, has_centre) {
        (3, true) => Some(3),
        (_, true) => None,
        (order, false) => {
            let highest = improper.clone().map(|turn| turn.order).max();
            // Without a centre on it only 2 and 3 can become -4 and -6.
            highest.filter(|improper| *improper == 2 * order)
        }
    };
    let point_at = |height: Fraction| {
        let (point, direction) = (line.point(), line.direction());
        [0, 1, 2].map(|i| modulo_one(point[i] + height * direction[i]))
    };
    let mut inversion_points: Vec<_> = improper.map(|turn| point_at(turn.along)).collect();
    inversion_points.sort();
    inversion_points.dedup();
    let mut operations: Vec<usize> = turns.iter().map(|turn| turn.operation).collect();
    operations.sort_unstable();
    operations.dedup();
    Some(Axis {
        line,
        order: highest.order,
        screw,
        period,
        rotoinversion,
        has_centre,
        inversion_points,
        operations,
    })
}

/// The shortest translation of the centred lattice along a primitive direction, as a part of it.
fn period(direction: [i64; 3], centrings: &[[Fraction; 3]]) -> Fraction {
    let basis = LatticeBasis::completing(direction);
    let along = centrings.iter().filter_map(|centring| {
        let [across, aside, along] = basis.coordinates(*centring).map(modulo_one);
        let zero = Fraction::from(0);
        (across == zero && aside == zero && along != zero).then_some(along)
    });
    along.min().unwrap_or(Fraction::from(1))
}
