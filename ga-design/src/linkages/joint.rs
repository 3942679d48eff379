//! How two bodies can move against each other.

use std::f64::consts::{PI, TAU};

use ga_cga::{DirectionVector, DualLine, Motor, Trivector3};
use ga_core::Unit;

use super::Axis;

/// One way to move: a screw about, along, or about and along an axis of the joint's frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Freedom {
    /// A rotation about an axis, in radians.
    Turn(Axis),
    /// A translation along an axis.
    Slide(Axis),
    /// A rotation about the z-axis in radians, with a rise along it for every whole turn.
    Screw {
        /// The rise of a whole turn.
        pitch: f64,
    },
}

/// The kind of a joint, whose frame has its z-axis along the joint's axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum JointKind {
    /// No movement.
    Fixed,
    /// A hinge: a rotation about z.
    Revolute,
    /// A slider: a translation along z.
    Prismatic,
    /// A rotation about z and a translation along it, each for itself.
    Cylindrical,
    /// A nut on a bolt: a rotation about z that rises.
    Helical {
        /// The rise of a whole turn.
        pitch: f64,
    },
    /// A cross: a rotation about x, then one about the y-axis that it has turned.
    Universal,
    /// A ball in a socket: rotations about x, y and z, each about the axis that those before have
    /// turned. It is singular where the second is a right angle.
    Spherical,
    /// A block on a table: translations along x and y and a rotation about z.
    Planar,
}

/// The range of one joint value, in radians or lengths.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limits {
    /// The least value.
    pub lower: f64,
    /// The largest value.
    pub upper: f64,
}

/// A joint: its kind, and the ranges of its values in the order of its freedoms.
#[derive(Debug, Clone, PartialEq)]
pub struct Joint {
    /// What it can do.
    pub kind: JointKind,
    /// How far, for each freedom; a freedom without an entry is unlimited.
    pub limits: Vec<Limits>,
}

impl Limits {
    /// From the least to the largest value; `None` if they are not numbers or the wrong way round.
    #[must_use]
    pub fn new(lower: f64, upper: f64) -> Option<Self> {
        (lower <= upper).then_some(Limits { lower, upper })
    }

    /// Any value.
    #[must_use]
    pub fn unlimited() -> Self {
        Limits {
            lower: f64::NEG_INFINITY,
            upper: f64::INFINITY,
        }
    }

    /// Whether a value is inside.
    #[must_use]
    pub fn contains(self, value: f64) -> bool {
        (self.lower..=self.upper).contains(&value)
    }

    /// The nearest value inside.
    #[must_use]
    pub fn nearest(self, value: f64) -> f64 {
        value.clamp(self.lower, self.upper)
    }

    /// The value half-way; of an unlimited range 0, of one limited on one side that side.
    #[must_use]
    pub fn middle(self) -> f64 {
        match (self.lower.is_finite(), self.upper.is_finite()) {
            (true, true) => 0.5 * self.lower + 0.5 * self.upper,
            _ => self.nearest(0.0),
        }
    }

    /// The range that random values are drawn from: half a turn or a unit each way where there is
    /// no limit.
    #[must_use]
    pub fn bounded(self) -> Self {
        Limits {
            lower: self.lower.max(self.upper.min(PI) - 2.0 * PI),
            upper: self.upper.min(self.lower.max(-PI) + 2.0 * PI),
        }
    }
}

impl JointKind {
    /// The ways it can move, in the order in which its values are given and its motions follow
    /// each other outwards.
    #[must_use]
    pub fn freedoms(self) -> Vec<Freedom> {
        use Freedom::{Screw, Slide, Turn};
        match self {
            JointKind::Fixed => Vec::new(),
            JointKind::Revolute => vec![Turn(Axis::Z)],
            JointKind::Prismatic => vec![Slide(Axis::Z)],
            JointKind::Cylindrical => vec![Turn(Axis::Z), Slide(Axis::Z)],
            JointKind::Helical { pitch } => vec![Screw { pitch }],
            JointKind::Universal => vec![Turn(Axis::X), Turn(Axis::Y)],
            JointKind::Spherical => vec![Turn(Axis::X), Turn(Axis::Y), Turn(Axis::Z)],
            JointKind::Planar => vec![Slide(Axis::X), Slide(Axis::Y), Turn(Axis::Z)],
        }
    }
}

impl Freedom {
    /// The screw S of the movement in the joint's frame: a dual line for a turn, **B** + **d** n_∞,
    /// its direction times n_∞ for a slide, and both for what rises as it turns.
    #[must_use]
    pub fn screw(self) -> DualLine {
        let turn = |axis: Axis| DualLine::from(axis.vector() * Trivector3::new(1.0));
        let slide = |axis: Axis| DualLine::from(DirectionVector::along(axis.vector()));
        match self {
            Freedom::Turn(axis) => turn(axis),
            Freedom::Slide(axis) => slide(axis),
            Freedom::Screw { pitch } => turn(Axis::Z) + slide(Axis::Z) * (pitch / TAU),
        }
    }

    /// The motion by a value in the joint's frame, e^{−q S/2}: e^{−θ e₁₂/2} for a turn about z.
    #[must_use]
    pub fn motion(self, value: f64) -> Unit<Motor> {
        Unit::promised((self.screw() * (-0.5 * value)).exp())
    }
}
