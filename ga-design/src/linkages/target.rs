//! What an arm is asked to reach, and how far a pose is from it.

use ga_cga::{Point, Rotor, Vector3};

use super::{Axis, Frame};

/// What of the tool's orientation is asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Attitude {
    /// All of it.
    Fixed,
    /// That an axis of the tool points as that of the target does; the tool may turn about it, as
    /// a drill may.
    Along(Axis),
    /// Nothing.
    Free,
}

/// What the tool of an arm is to reach: a frame, wholly or in part.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Target {
    /// The frame.
    pub frame: Frame,
    /// Along which axes of the frame the position counts.
    pub position: [bool; 3],
    /// What of the orientation counts.
    pub attitude: Attitude,
}

/// How far a pose is from a target, as far as it counts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Miss {
    /// The distance.
    pub position: f64,
    /// The angle in radians.
    pub rotation: f64,
}

impl Target {
    /// Position and orientation.
    #[must_use]
    pub fn pose(frame: Frame) -> Self {
        Target {
            frame,
            position: [true; 3],
            attitude: Attitude::Fixed,
        }
    }

    /// A position in any orientation; `None` for a point too far away to compute with.
    #[must_use]
    pub fn position(point: Point) -> Option<Self> {
        Some(Target {
            attitude: Attitude::Free,
            ..Target::pose(Frame::at(point, Rotor::identity())?)
        })
    }

    /// How far a pose is from it.
    #[must_use]
    pub fn miss(&self, pose: Frame) -> Miss {
        let [position, rotation] = self.error(pose.relative_to(self.frame));
        Miss {
            position: position.norm(),
            rotation: rotation.norm(),
        }
    }

    /// The displacement and the rotation vector, in radians, from a pose to the target, both
    /// along the target's axes. The pose is told in the target's frame.
    pub(super) fn error(&self, pose: Frame) -> [Vector3; 2] {
        let position = pose.origin().position().to_array();
        let counted = std::array::from_fn(|axis| match self.position.get(axis) {
            Some(true) => -position.get(axis).copied().unwrap_or(0.0),
            _ => 0.0,
        });
        let rotation = match self.attitude {
            Attitude::Free => Vector3::default(),
            Attitude::Fixed => rotation_vector(pose.attitude().reverse()),
            Attitude::Along(axis) => {
                let (own, wanted) = (pose.axis(axis), axis.vector());
                // Half a turn, whichever, where they are opposite.
                let turn = Rotor::between_in(own, wanted, axis.plane_through());
                turn.map_or(Vector3::default(), rotation_vector)
            }
        };
        [Vector3::from(counted), rotation]
    }

    /// Which of the three displacements and the three rotations count.
    pub(super) fn rows(&self) -> [bool; 6] {
        let [x, y, z] = self.position;
        let [rx, ry, rz] = match self.attitude {
            Attitude::Fixed => [true; 3],
            Attitude::Along(Axis::X) => [false, true, true],
            Attitude::Along(Axis::Y) => [true, false, true],
            Attitude::Along(Axis::Z) => [true, true, false],
            Attitude::Free => [false; 3],
        };
        [x, y, z, rx, ry, rz]
    }
}

/// The axis of a rotation times its angle in radians, of at most half a turn.
pub(super) fn rotation_vector(rotor: Rotor) -> Vector3 {
    let sine = Vector3::new(-rotor.e23, rotor.e13, -rotor.e12);
    let (length, cosine) = (sine.norm(), rotor.s);
    let angle = 2.0 * length.atan2(cosine.abs());
    match length > f64::MIN_POSITIVE {
        true => sine * (angle.copysign(cosine) / length),
        false => Vector3::default(),
    }
}
