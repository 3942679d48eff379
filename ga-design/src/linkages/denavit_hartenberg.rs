//! Tables of Denavit and Hartenberg, in their own convention and in Craig's, as chains.

mod reader;

use ga_cga::Motor;
use ga_core::Unit;

use super::link::{about, along};
use super::{Axis, Chain, Coupling, Frame, Joint, JointKind, Limits, Link};

pub use reader::TableError;

/// In which order a row's four motions follow each other.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Convention {
    /// Denavit and Hartenberg's: Rz(θ) Tz(d) Tx(a) Rx(α), the joint before its link.
    Standard,
    /// Craig's: Rx(α) Tx(a) Rz(θ) Tz(d), the link before its joint, with a and α of the link
    /// before.
    Modified,
}

/// A row of a table: a joint and a link.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Row {
    /// Whether the joint slides, so that its value is added to d; else it turns, and its value is
    /// added to θ.
    pub is_prismatic: bool,
    /// The angle θ about z in radians, where the joint does not turn.
    pub theta: f64,
    /// The distance d along z, where the joint does not slide.
    pub d: f64,
    /// The length a along x.
    pub a: f64,
    /// The twist α about x in radians.
    pub alpha: f64,
    /// What is added to the joint value.
    pub offset: f64,
    /// Whether the joint value is counted the other way.
    pub is_flipped: bool,
    /// The range of the joint value.
    pub limits: Limits,
}

/// A table of Denavit–Hartenberg rows with base and tool.
#[derive(Debug, Clone, PartialEq)]
pub struct Table {
    /// How rows are read.
    pub convention: Convention,
    /// The rows, from the base outwards.
    pub rows: Vec<Row>,
    /// Where the first row starts.
    pub base: Frame,
    /// From the last row's frame to the tool.
    pub tool: Unit<Motor>,
}

impl Row {
    /// What stands between the joint and the next row: Tx(a) Rx(α), which commute.
    fn link(&self) -> Motor {
        along(Axis::X, self.a) * about(Axis::X, self.alpha)
    }

    /// Where the joint stands at the value 0, along and about its own axis: Rz(θ) Tz(d), which
    /// commute with the joint's motion.
    fn rest(&self) -> Motor {
        let [theta, d] = match self.is_prismatic {
            true => [self.theta, self.d + self.offset],
            false => [self.theta + self.offset, self.d],
        };
        along(Axis::Z, d) * about(Axis::Z, theta)
    }

    fn joint(&self) -> Joint {
        Joint {
            kind: match self.is_prismatic {
                true => JointKind::Prismatic,
                false => JointKind::Revolute,
            },
            limits: vec![self.limits],
        }
    }
}

impl Table {
    /// The chain of a table. The frame of body i is that which the convention gives number i, and
    /// its joint is named by that number, `joint 1` first.
    #[must_use]
    pub fn chain(&self, name: impl Into<String>) -> Chain {
        let identity = Unit::promised(Motor::identity());
        let mut chain = Chain::new(name, self.base);
        for (number, row) in self.rows.iter().enumerate() {
            let [link, rest] = [row.link(), row.rest()].map(Unit::promised);
            let steps = match self.convention {
                Convention::Standard => [identity, rest * link],
                Convention::Modified => [link, rest],
            };
            chain = chain.with(format!("joint {}", number + 1), steps, row.joint());
            if row.is_flipped {
                chain = chain.driven_by(vec![Coupling {
                    value: number,
                    ratio: -1.0,
                    offset: 0.0,
                }]);
            }
        }
        chain.with_tool(self.tool)
    }

    /// The links of the dissertation that make the same chain: T = Q⁻¹ (J₁ L₁ … Jₙ Lₙ) Q with Q a
    /// quarter turn about z, lengths a, offsets d and skews −α (§4.3). Each is told with
    /// the rotation that comes before the joint's own.
    ///
    /// `None` for Craig's convention, whose first link lies before the first joint, and for
    /// prismatic joints, which the dissertation has not.
    #[must_use]
    pub fn links(&self) -> Option<Vec<(f64, Link)>> {
        let revolute = self
            .rows
            .iter()
            .all(|row| !row.is_prismatic && !row.is_flipped);
        let standard = self.convention == Convention::Standard && revolute;
        let link = |row: &Row| {
            let link = Link {
                length: row.a,
                skew: -row.alpha,
                offset: row.d,
            };
            (row.theta + row.offset, link)
        };
        standard.then(|| self.rows.iter().map(link).collect())
    }

    /// The same chain in the other convention. From Craig's rows a and α move one row up, and what
    /// stands before the first joint joins the base; into Craig's they move one row down, and what
    /// stands behind the last joint joins the tool.
    #[must_use]
    pub fn converted(&self) -> Table {
        let mut table = self.clone();
        let shifted = |from: Option<&Row>| from.map_or([0.0; 2], |row| [row.a, row.alpha]);
        match self.convention {
            Convention::Modified => {
                let first = self.rows.first().map(Row::link);
                let first = Unit::promised(first.unwrap_or(Motor::identity()));
                table.base = self.base.then(first);
                for (number, row) in table.rows.iter_mut().enumerate() {
                    [row.a, row.alpha] = shifted(self.rows.get(number + 1));
                }
                table.convention = Convention::Standard;
            }
            Convention::Standard => {
                let last = self.rows.last().map(Row::link);
                let last = Unit::promised(last.unwrap_or(Motor::identity()));
                table.tool = last * self.tool;
                for (number, row) in table.rows.iter_mut().enumerate() {
                    let before = number
                        .checked_sub(1)
                        .and_then(|before| self.rows.get(before));
                    [row.a, row.alpha] = shifted(before);
                }
                table.convention = Convention::Modified;
            }
        }
        table
    }
}
