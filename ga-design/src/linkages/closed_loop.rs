//! Loops of links and hinges: how they close, how they move, and how freely (4.3).

mod motion;
mod newton;

use ga_cga::{DualLine, Motor, Point};
use ga_core::Unit;
use nalgebra::{DMatrix, DVector};
use thiserror::Error;

use super::{Axis, Frame, Freedom, Link};
pub use motion::{Motion, Turn};

/// A closed chain of hinges: joint i turns about the z-axis of frame i by θᵢ, and link i leads to
/// frame i + 1, the last one back to the first: J₁ L₁ J₂ L₂ … Jₙ Lₙ = 1.
#[derive(Debug, Clone, PartialEq)]
pub struct ClosedLoop {
    links: Vec<Link>,
    motions: Vec<Unit<Motor>>,
    size: f64,
}

/// A configuration of a closed loop.
#[derive(Debug, Clone, PartialEq)]
pub struct LoopState {
    /// The joint angles in radians, in (−π, π].
    pub angles: Vec<f64>,
    /// How far the last link is from the first joint: the larger of the distance over the longest
    /// link, and the angle.
    pub residual: f64,
}

/// How freely a loop moves.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Mobility {
    /// By the count of Kutzbach, 6 (n − 1) − 5 n for n hinges (4.3), which knows nothing of the
    /// dimensions.
    pub kutzbach: i64,
    /// The rank of the joints' screws.
    pub rank: usize,
    /// The freedoms of the loop where it stands: joints without rank.
    pub freedoms: usize,
}

/// Why a loop is none, or does not close.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum LoopError {
    /// Fewer than three links.
    #[error("{given} links make no loop: it takes at least 3")]
    FewLinks {
        /// How many there are.
        given: usize,
    },
    /// More links than are computed with.
    #[error("{given} links are too many for a loop: at most {most}")]
    ManyLinks {
        /// How many there are.
        given: usize,
        /// How many there may be.
        most: usize,
    },
    /// A number is not finite, or out of its range.
    #[error("{what} is {value}: it must be {range}")]
    Number {
        /// Which number.
        what: String,
        /// The number.
        value: f64,
        /// The range in words.
        range: &'static str,
    },
    /// There are not as many angles as joints.
    #[error("{given} angles for a loop of {joints} joints: give one for each")]
    Angles {
        /// How many are given.
        given: usize,
        /// How many there are to be.
        joints: usize,
    },
    /// There is no such joint.
    #[error("there is no joint {joint}: the loop has {joints}")]
    Joint {
        /// The joint, counted from 1.
        joint: usize,
        /// How many there are.
        joints: usize,
    },
    /// The dimensions of the linkage contradict each other.
    #[error("{0}")]
    Impossible(String),
    /// No angles were found that close the loop.
    #[error(
        "the loop does not close with joint {joint} at {value} rad: the nearest configuration found \
         misses by {residual:.3e}; choose an angle inside its range of motion"
    )]
    Open {
        /// The driven joint, counted from 1.
        joint: usize,
        /// Its angle.
        value: f64,
        /// What is missing, over the longest link.
        residual: f64,
    },
}

/// How many links a loop may have.
pub const MOST_LINKS: usize = 1000;

/// Singular values below this part of the largest count as zero.
const RANK: f64 = 1e-7;

/// What a loop may miss by to be called closed.
pub const CLOSED: f64 = 1e-12;

impl ClosedLoop {
    /// The loop of these links.
    ///
    /// # Errors
    /// [`LoopError`] for fewer than three links, too many, and numbers that are not finite or too
    /// large.
    pub fn new(links: Vec<Link>) -> Result<Self, LoopError> {
        match links.len() {
            given @ ..3 => return Err(LoopError::FewLinks { given }),
            given if given > MOST_LINKS => {
                return Err(LoopError::ManyLinks {
                    given,
                    most: MOST_LINKS,
                });
            }
            _ => {}
        }
        for (number, link) in links.iter().enumerate() {
            let numbers = [
                ("length", link.length),
                ("skew", link.skew),
                ("offset", link.offset),
            ];
            if let Some((name, value)) = numbers
                .into_iter()
                .find(|(_, value)| value.is_nan() || value.abs() >= 1e100)
            {
                return Err(LoopError::Number {
                    what: format!("the {name} of link {}", number + 1),
                    value,
                    range: "finite, and below 1e100",
                });
            }
        }
        let lengths = links.iter().map(|link| link.length.hypot(link.offset));
        let size = lengths.fold(0.0, f64::max);
        Ok(ClosedLoop {
            motions: links.iter().map(|link| link.motion()).collect(),
            links,
            // Spherical loops have no lengths, and nothing to compare distances with.
            size: if size > 0.0 { size } else { 1.0 },
        })
    }

    /// The links.
    #[must_use]
    pub fn links(&self) -> &[Link] {
        &self.links
    }

    /// How many joints there are.
    #[must_use]
    pub fn joints(&self) -> usize {
        self.links.len()
    }

    /// The frames of all joints, each turned by its angle, the first of them about the world's
    /// z-axis at the origin.
    ///
    /// # Errors
    /// [`LoopError::Angles`] and [`LoopError::Number`].
    pub fn frames(&self, angles: &[f64]) -> Result<Vec<Frame>, LoopError> {
        self.check(angles)?;
        Ok(self.walk(angles).0)
    }

    /// Where the joints stand.
    ///
    /// # Errors
    /// As [`frames`](ClosedLoop::frames).
    pub fn points(&self, angles: &[f64]) -> Result<Vec<Point>, LoopError> {
        let frames = self.frames(angles)?;
        Ok(frames.into_iter().map(Frame::origin).collect())
    }

    /// A configuration with what it misses by.
    ///
    /// # Errors
    /// As [`frames`](ClosedLoop::frames).
    pub fn state(&self, angles: &[f64]) -> Result<LoopState, LoopError> {
        self.check(angles)?;
        Ok(self.judged(angles))
    }

    /// How freely the loop moves where it stands.
    ///
    /// # Errors
    /// As [`frames`](ClosedLoop::frames).
    pub fn mobility(&self, angles: &[f64]) -> Result<Mobility, LoopError> {
        self.check(angles)?;
        let rank = rank(&self.jacobian(angles).singular_values());
        let joints = self.joints();
        Ok(Mobility {
            kutzbach: joints as i64 - 6,
            rank,
            freedoms: joints - rank.min(joints),
        })
    }

    fn check(&self, angles: &[f64]) -> Result<(), LoopError> {
        if angles.len() != self.joints() {
            return Err(LoopError::Angles {
                given: angles.len(),
                joints: self.joints(),
            });
        }
        match angles.iter().position(|angle| !angle.is_finite()) {
            Some(joint) => Err(LoopError::Number {
                what: format!("the angle of joint {}", joint + 1),
                value: angles.get(joint).copied().unwrap_or(f64::NAN),
                range: "finite",
            }),
            None => Ok(()),
        }
    }

    /// Refuses the number of a joint, counted from 0, that is not there.
    fn check_joint(&self, joint: usize) -> Result<(), LoopError> {
        match joint < self.joints() {
            true => Ok(()),
            false => Err(LoopError::Joint {
                joint: joint.saturating_add(1),
                joints: self.joints(),
            }),
        }
    }

    /// All frames, and the motion that the loop should take back to nothing.
    fn walk(&self, angles: &[f64]) -> (Vec<Frame>, Unit<Motor>) {
        let mut frame = Frame::world();
        let mut frames = Vec::with_capacity(self.joints());
        for (motion, angle) in self.motions.iter().zip(angles) {
            frame = frame.then(Freedom::Turn(Axis::Z).motion(*angle));
            frames.push(frame);
            frame = frame.then(*motion);
        }
        (frames, frame.motor())
    }

    /// The screw that is missing: of the two motors of a motion that with the shorter turn.
    fn gap(&self, closing: Unit<Motor>) -> [f64; 6] {
        let frame = Frame::promised(closing);
        let turn = super::target::rotation_vector(frame.attitude()).to_array();
        let shift = (frame.origin().position() / self.size).to_array();
        let [x, y, z] = shift;
        let [rx, ry, rz] = turn;
        [x, y, z, rx, ry, rz]
    }

    fn judged(&self, angles: &[f64]) -> LoopState {
        let [x, y, z, rx, ry, rz] = self.gap(self.walk(angles).1);
        let length = |[x, y, z]: [f64; 3]| x.hypot(y).hypot(z);
        LoopState {
            angles: angles.iter().map(|angle| principal(*angle)).collect(),
            residual: length([x, y, z]).max(length([rx, ry, rz])),
        }
    }

    /// The screws of all joints in the first frame as columns, distances over the size of the loop.
    fn jacobian(&self, angles: &[f64]) -> DMatrix<f64> {
        let (frames, _) = self.walk(angles);
        let columns = frames.into_iter().map(|frame| {
            let screw: DualLine = frame.motor().apply(Freedom::Turn(Axis::Z).screw());
            let [xy, xz, yz, dx, dy, dz] = screw.to_array();
            let [dx, dy, dz] = [dx, dy, dz].map(|part| part / self.size);
            DVector::from_column_slice(&[dx, dy, dz, yz, -xz, xy])
        });
        DMatrix::from_columns(&columns.collect::<Vec<_>>())
    }
}

/// How many singular values are not zero against the largest.
fn rank(values: &DVector<f64>) -> usize {
    let largest = values.iter().copied().fold(0.0, f64::max);
    values
        .iter()
        .filter(|value| **value > RANK * largest)
        .count()
}

/// An angle in (−π, π].
fn principal(angle: f64) -> f64 {
    use std::f64::consts::{PI, TAU};
    let turned = angle.rem_euclid(TAU);
    if turned > PI { turned - TAU } else { turned }
}
