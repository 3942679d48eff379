//! What a chain of joints and links is, and where its frames stand for given joint values (4.2).

use ga_cga::{DualLine, Motor};
use ga_core::Unit;
use thiserror::Error;

use super::{Frame, Freedom, Joint, JointKind, Limits};

/// A body and the joint that it hangs on.
#[derive(Debug, Clone, PartialEq)]
pub struct Segment {
    /// The name of the joint, for messages and tables.
    pub name: String,
    /// From the frame of the body before, or from the base, to the frame of the joint.
    pub before: Unit<Motor>,
    /// What the joint can do.
    pub kind: JointKind,
    /// From the frame of the joint, moved, to that of the body.
    pub after: Unit<Motor>,
    /// Which values drive its freedoms, one coupling for each.
    pub couplings: Vec<Coupling>,
}

/// How a freedom follows a joint value: by `ratio` times the value, plus `offset`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Coupling {
    /// The number of the value.
    pub value: usize,
    /// What the value is multiplied by.
    pub ratio: f64,
    /// What is added.
    pub offset: f64,
}

/// A value that a user of the chain gives: one for each freedom that mimics no other.
#[derive(Debug, Clone, PartialEq)]
pub struct JointValue {
    /// The name of the joint; with a number behind where the joint has several values.
    pub name: String,
    /// Its range.
    pub limits: Limits,
}

/// An open chain of joints from a base to a tool.
///
/// ```
/// use std::f64::consts::FRAC_PI_2;
/// use ga_cga::Point;
/// use ga_design::linkages::{Chain, Frame, Joint, JointKind, Link};
///
/// // Two links of length 1 whose hinges are parallel, as the dissertation has them: L, then J.
/// let hinge = || Joint { kind: JointKind::Revolute, limits: Vec::new() };
/// let link = Link { length: 1.0, skew: 0.0, offset: 0.0 }.motion();
/// let arm = Chain::new("arm", Frame::world())
///     .with("shoulder", [Frame::world().motor(), link], hinge())
///     .with("elbow", [Frame::world().motor(), link], hinge());
/// let tip = arm.pose(&[0.0, FRAC_PI_2])?.origin();
/// assert!(tip.distance(Point::at(-1.0, 1.0, 0.0)) < 1e-15);
/// # Ok::<(), ga_design::linkages::ChainError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Chain {
    name: String,
    base: Frame,
    segments: Vec<Segment>,
    values: Vec<JointValue>,
    tool: Unit<Motor>,
}

/// What a chain cannot be asked.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum ChainError {
    /// As many values as there are freedoms must be given.
    #[error("{given} joint values for {name}: it takes {taken}, {names}")]
    Values {
        /// The chain.
        name: String,
        /// How many are given.
        given: usize,
        /// How many it takes.
        taken: usize,
        /// Their names.
        names: String,
    },
    /// A value is infinite or not a number.
    #[error("the value of {joint} is {value}: it must be finite")]
    NotFinite {
        /// The joint.
        joint: String,
        /// Its value.
        value: f64,
    },
}

impl Chain {
    /// Changes what drives the freedoms of the last body: a joint that mimics another, or counts
    /// the other way. Values that drive nothing then are taken out.
    #[must_use]
    pub fn driven_by(mut self, couplings: Vec<Coupling>) -> Self {
        if let Some(segment) = self.segments.last_mut() {
            segment.couplings = couplings;
        }
        let used = |number: usize| {
            let mut couplings = self.segments.iter().flat_map(|segment| &segment.couplings);
            couplings.any(|coupling| coupling.value == number)
        };
        let last = (0..self.values.len()).rev().find(|number| used(*number));
        self.values.truncate(last.map_or(0, |last| last + 1));
        self
    }

    /// A chain without joints, from a base.
    #[must_use]
    pub fn new(name: impl Into<String>, base: Frame) -> Self {
        Chain {
            name: name.into(),
            base,
            segments: Vec::new(),
            values: Vec::new(),
            tool: Unit::promised(Motor::identity()),
        }
    }

    /// The chain with another body, whose joint has values of its own, limits as far as it has
    /// them.
    #[must_use]
    pub fn with(
        mut self,
        name: impl Into<String>,
        [before, after]: [Unit<Motor>; 2],
        joint: Joint,
    ) -> Self {
        let name = name.into();
        let freedoms = joint.kind.freedoms().len();
        let mut couplings = Vec::with_capacity(freedoms);
        for number in 0..freedoms {
            couplings.push(Coupling::to(self.values.len()));
            let limits = joint.limits.get(number).copied();
            self.values.push(JointValue {
                name: match freedoms {
                    1 => name.clone(),
                    _ => format!("{name} {}", number + 1),
                },
                limits: limits.unwrap_or(Limits::unlimited()),
            });
        }
        self.push(Segment {
            name,
            before,
            kind: joint.kind,
            after,
            couplings,
        });
        self
    }

    /// The chain with a tool: from the frame of the last body to that which is told as the pose.
    #[must_use]
    pub fn with_tool(mut self, tool: Unit<Motor>) -> Self {
        self.tool = tool;
        self
    }

    /// Its name.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Where it starts.
    #[must_use]
    pub fn base(&self) -> Frame {
        self.base
    }

    /// From the frame of the last body to that which is told as the pose.
    #[must_use]
    pub fn tool(&self) -> Unit<Motor> {
        self.tool
    }

    /// The bodies with their joints, from the base outwards.
    #[must_use]
    pub fn segments(&self) -> &[Segment] {
        &self.segments
    }

    /// The values that a pose takes, in their order.
    #[must_use]
    pub fn values(&self) -> &[JointValue] {
        &self.values
    }

    /// The pose of the tool for joint values, radians or lengths: M = Mᵢ₋₁ Lᵢ₋₁ Jᵢ from body to
    /// body (4.1, 4.2), then the tool.
    ///
    /// # Errors
    /// As [`frames`](Chain::frames).
    pub fn pose(&self, values: &[f64]) -> Result<Frame, ChainError> {
        let frames = self.frames(values)?;
        let last = frames.last().copied().unwrap_or(self.base);
        Ok(last.then(self.tool))
    }

    /// The frame of every body, for joint values, radians or lengths; the tool apart.
    ///
    /// # Errors
    /// [`ChainError::Values`] if they are not as many as [`values`](Chain::values), and
    /// [`ChainError::NotFinite`].
    pub fn frames(&self, values: &[f64]) -> Result<Vec<Frame>, ChainError> {
        self.check(values)?;
        let mut frame = self.base;
        let frames = self.segments.iter().map(|segment| {
            frame = frame.then(segment.before);
            for (freedom, coupling) in segment.freedoms() {
                frame = frame.then(freedom.motion(coupling.of(values)));
            }
            frame = frame.then(segment.after);
            frame
        });
        Ok(frames.collect())
    }

    /// The screw of every freedom in the world, for joint values: what moves with it moves as
    /// e^{−t S/2}. They are dual lines where the freedoms are turns.
    ///
    /// # Errors
    /// As [`frames`](Chain::frames).
    pub fn screws(&self, values: &[f64]) -> Result<Vec<DualLine>, ChainError> {
        self.check(values)?;
        let mut frame = self.base;
        let mut screws = Vec::new();
        for segment in &self.segments {
            frame = frame.then(segment.before);
            for (freedom, coupling) in segment.freedoms() {
                screws.push(frame.motor().apply(freedom.screw()));
                frame = frame.then(freedom.motion(coupling.of(values)));
            }
            frame = frame.then(segment.after);
        }
        Ok(screws)
    }

    /// Adds a body whose couplings name values that are there.
    pub(super) fn push(&mut self, segment: Segment) {
        self.segments.push(segment);
    }

    /// The number of the value of that name, which is added if it is not there.
    pub(super) fn value_named(&mut self, name: &str, limits: Limits) -> usize {
        let place = self.values.iter().position(|value| value.name == name);
        place.unwrap_or_else(|| {
            self.values.push(JointValue {
                name: name.to_owned(),
                limits,
            });
            self.values.len() - 1
        })
    }

    /// Refuses values that are too few, too many or not finite.
    pub(super) fn check(&self, values: &[f64]) -> Result<(), ChainError> {
        if values.len() != self.values.len() {
            let names: Vec<&str> = self
                .values
                .iter()
                .map(|value| value.name.as_str())
                .collect();
            return Err(ChainError::Values {
                name: self.name.clone(),
                given: values.len(),
                taken: names.len(),
                names: names.join(", "),
            });
        }
        match values
            .iter()
            .zip(&self.values)
            .find(|(x, _)| !x.is_finite())
        {
            Some((value, joint)) => Err(ChainError::NotFinite {
                joint: joint.name.clone(),
                value: *value,
            }),
            None => Ok(()),
        }
    }
}

impl Segment {
    /// The freedoms of the joint with what drives them.
    pub(super) fn freedoms(&self) -> impl Iterator<Item = (Freedom, &Coupling)> {
        self.kind.freedoms().into_iter().zip(&self.couplings)
    }
}

impl Coupling {
    /// The value as it is.
    pub(super) fn to(value: usize) -> Self {
        Coupling {
            value,
            ratio: 1.0,
            offset: 0.0,
        }
    }

    /// The value of the freedom, given all values of the chain; 0 for one that is not there.
    pub(super) fn of(&self, values: &[f64]) -> f64 {
        let value = values.get(self.value).copied().unwrap_or(0.0);
        self.ratio * value + self.offset
    }
}
