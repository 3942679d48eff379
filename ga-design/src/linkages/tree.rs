//! Robots as URDF files describe them: a tree of bodies, and the chain from its root to a tip.

mod error;
mod order;

use ga_cga::{Bivector3, Motor, Rotor, Translator, Vector3};
use ga_core::Unit;
use urdf_rs::{Joint as Described, JointType, Robot};

use super::link::about;
use super::{Axis, Chain, Coupling, Frame, JointKind, Limits, Segment};
pub use error::TreeError;

/// A robot as a tree of bodies that joints hang on each other.
#[derive(Debug, Clone)]
pub struct Tree {
    robot: Robot,
    /// For each body the joint that it hangs on; none for the root.
    parents: Vec<Option<usize>>,
}

impl Tree {
    /// Reads a robot from the text of a URDF file. Lengths are in metres, angles in radians.
    ///
    /// # Errors
    /// [`TreeError`]: the text is no URDF, or bodies and joints make no tree, or a joint has an
    /// axis, numbers or limits that mean nothing.
    pub fn from_urdf(text: &str) -> Result<Self, TreeError> {
        let robot =
            urdf_rs::read_from_string(text).map_err(|error| TreeError::Urdf(error.to_string()))?;
        let parents = order::parents(&robot)?;
        for joint in &robot.joints {
            check(joint, &robot)?;
        }
        Ok(Tree { robot, parents })
    }

    /// Its name.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.robot.name
    }

    /// The bodies that no other hangs on, in the order of the file.
    #[must_use]
    pub fn tips(&self) -> Vec<&str> {
        let is_tip = |name: &str| {
            self.robot
                .joints
                .iter()
                .all(|joint| joint.parent.link != name)
        };
        let names = self.robot.links.iter().map(|link| link.name.as_str());
        names.filter(|name| is_tip(name)).collect()
    }

    /// The chain from the root to a body, or, without one, to the only tip.
    ///
    /// Its base is the frame of the root, its bodies and joints are those on the way, and its pose
    /// is the frame of the body. A joint that mimics one that is not on the way takes the value of
    /// that one.
    ///
    /// # Errors
    /// [`TreeError::Tip`] for a body that is not there, [`TreeError::Tips`] if there are several
    /// tips and none is chosen, [`TreeError::Floating`] and [`TreeError::Mimic`] for joints on the
    /// way.
    pub fn chain(&self, tip: Option<&str>) -> Result<Chain, TreeError> {
        let tips = self.tips();
        let list = || tips.join(", ");
        let tip = match (tip, tips.as_slice()) {
            (Some(tip), _) => tip,
            (None, [tip]) => tip,
            (None, _) => return Err(TreeError::Tips { tips: list() }),
        };
        let place = |name: &str| self.robot.links.iter().position(|link| link.name == name);
        let mut body = place(tip).ok_or_else(|| TreeError::Tip {
            tip: tip.to_owned(),
            tips: list(),
        })?;
        let mut way = Vec::new();
        while let Some(joint) = self.joint_of(body) {
            way.push(joint);
            match place(&joint.parent.link) {
                Some(parent) => body = parent,
                None => break,
            }
        }
        let mut chain = Chain::new(self.name(), Frame::world());
        for joint in way.into_iter().rev() {
            chain = self.hung(chain, joint)?;
        }
        Ok(chain)
    }

    fn joint_of(&self, body: usize) -> Option<&Described> {
        let joint = self.parents.get(body).copied().flatten()?;
        self.robot.joints.get(joint)
    }

    /// The chain with the body of a joint.
    fn hung(&self, mut chain: Chain, joint: &Described) -> Result<Chain, TreeError> {
        let kind = kind(joint)?;
        let toward = match kind {
            JointKind::Fixed | JointKind::Spherical => Unit::promised(Motor::identity()),
            _ => upright(joint),
        };
        let couplings = match kind.freedoms().len() {
            0 => Vec::new(),
            1 => vec![self.coupling(&mut chain, joint)?],
            count => {
                let names = (1..=count).map(|number| format!("{} {number}", joint.name));
                let own = |name: String| chain.value_named(&name, Limits::unlimited());
                names.map(own).map(Coupling::to).collect()
            }
        };
        chain.push(Segment {
            name: joint.name.clone(),
            before: placement(joint) * toward,
            kind,
            after: toward.reverse(),
            couplings,
        });
        Ok(chain)
    }

    /// What drives a joint of one freedom: its own value, or that of the joint that it mimics,
    /// through all that this one mimics in turn.
    fn coupling(&self, chain: &mut Chain, joint: &Described) -> Result<Coupling, TreeError> {
        let (mut driver, mut ratio, mut offset) = (joint, 1.0, 0.0);
        // Longer than all joints together is a circle.
        for _ in &self.robot.joints {
            let Some(mimic) = &driver.mimic else {
                let value = chain.value_named(&driver.name, limits(driver));
                return Ok(Coupling {
                    value,
                    ratio,
                    offset,
                });
            };
            offset += ratio * mimic.offset.unwrap_or(0.0);
            ratio *= mimic.multiplier.unwrap_or(1.0);
            let mut joints = self.robot.joints.iter();
            let found = joints.find(|other| other.name == mimic.joint);
            driver = found.ok_or_else(|| TreeError::Mimic {
                joint: driver.name.clone(),
                problem: format!("`{}`, which is not there", mimic.joint),
            })?;
        }
        Err(TreeError::Mimic {
            joint: joint.name.clone(),
            problem: "itself in the end".to_owned(),
        })
    }
}

/// The kind of a joint.
fn kind(joint: &Described) -> Result<JointKind, TreeError> {
    match joint.joint_type {
        JointType::Fixed => Ok(JointKind::Fixed),
        JointType::Revolute | JointType::Continuous => Ok(JointKind::Revolute),
        JointType::Prismatic => Ok(JointKind::Prismatic),
        JointType::Planar => Ok(JointKind::Planar),
        JointType::Spherical => Ok(JointKind::Spherical),
        JointType::Floating => Err(TreeError::Floating {
            joint: joint.name.clone(),
        }),
    }
}

/// The range of a joint; a continuous one has none, whatever is written.
fn limits(joint: &Described) -> Limits {
    match joint.joint_type {
        JointType::Revolute | JointType::Prismatic => {
            Limits::new(joint.limit.lower, joint.limit.upper).unwrap_or(Limits::unlimited())
        }
        _ => Limits::unlimited(),
    }
}

/// From the frame of the body before to that of the joint: roll, pitch and yaw about the fixed
/// axes x, y and z, then the translation.
fn placement(joint: &Described) -> Unit<Motor> {
    let [roll, pitch, yaw] = joint.origin.rpy.0;
    let [x, y, z] = joint.origin.xyz.0;
    let turn = about(Axis::Z, yaw) * about(Axis::Y, pitch) * about(Axis::X, roll);
    Unit::promised(Translator::by(Vector3::new(x, y, z)) * turn)
}

/// The rotation that takes the z-axis to the joint's axis.
fn upright(joint: &Described) -> Unit<Motor> {
    let [x, y, z] = joint.axis.xyz.0;
    let floor = Bivector3::new(0.0, 1.0, 0.0);
    let turn = Rotor::between_in(Axis::Z.vector(), Vector3::new(x, y, z), floor);
    Unit::promised(Motor::from(turn.unwrap_or(Rotor::identity())))
}

/// Refuses numbers that mean nothing.
fn check(joint: &Described, robot: &Robot) -> Result<(), TreeError> {
    let wrong = |problem: String| TreeError::Joint {
        robot: robot.name.clone(),
        joint: joint.name.clone(),
        problem,
    };
    let numbers = [joint.origin.xyz.0, joint.origin.rpy.0, joint.axis.xyz.0];
    let limits = [joint.limit.lower, joint.limit.upper];
    let mimic = joint.mimic.as_ref();
    let mimic = mimic.map(|mimic| [mimic.multiplier.unwrap_or(1.0), mimic.offset.unwrap_or(0.0)]);
    let mut all = numbers
        .into_iter()
        .flatten()
        .chain(limits)
        .chain(mimic.into_iter().flatten());
    if let Some(number) = all.find(|number| !number.is_finite()) {
        return Err(wrong(format!("has the number {number}; write finite ones")));
    }
    let is_limited = matches!(joint.joint_type, JointType::Revolute | JointType::Prismatic);
    if is_limited && Limits::new(limits[0], limits[1]).is_none() {
        return Err(wrong(format!(
            "has limits from {} to {}; write the lesser number as `lower`",
            limits[0], limits[1]
        )));
    }
    let [x, y, z] = joint.axis.xyz.0;
    let moves = !matches!(
        joint.joint_type,
        JointType::Fixed | JointType::Spherical | JointType::Floating
    );
    if moves && Vector3::new(x, y, z).normalized().is_none() {
        return Err(wrong(
            "has an axis without direction; write one such as `0 0 1`".to_owned(),
        ));
    }
    Ok(())
}
