//! What is said of a robot that is no tree, or of a chain that it has not.

use thiserror::Error;

/// Why a URDF file gives no tree, or a tree no chain.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum TreeError {
    /// The text is not what URDF prescribes.
    #[error("no URDF: {0}")]
    Urdf(String),
    /// There is no body.
    #[error("robot `{robot}` has no link; write at least one `<link name=\"…\"/>`")]
    Empty {
        /// The robot.
        robot: String,
    },
    /// A name stands twice.
    #[error("robot `{robot}` has two {kind}s named `{name}`; give each a name of its own")]
    Twice {
        /// The robot.
        robot: String,
        /// Links or joints.
        kind: &'static str,
        /// Their name.
        name: String,
    },
    /// A joint names a body that is not there.
    #[error("joint `{joint}` hangs on link `{link}`, which is not there; the links are {links}")]
    MissingLink {
        /// The joint.
        joint: String,
        /// The body.
        link: String,
        /// Those that are there.
        links: String,
    },
    /// A body hangs on two joints.
    #[error(
        "link `{link}` is the child of joints `{}` and `{}`; a body hangs on one joint, and loops \
         are closed apart", joints[0], joints[1]
    )]
    TwoParents {
        /// The body.
        link: String,
        /// The joints.
        joints: [String; 2],
    },
    /// Bodies hang on each other in a circle.
    #[error("link `{link}` hangs on itself, by way of {way}; let one of these joints go")]
    Cycle {
        /// The body.
        link: String,
        /// The joints of the circle.
        way: String,
    },
    /// Some bodies are not connected.
    #[error("links {roots} hang on nothing; a robot has one root, so join all but one of them")]
    Roots {
        /// The bodies.
        roots: String,
    },
    /// Numbers of a joint mean nothing.
    #[error("joint `{joint}` of robot `{robot}` {problem}")]
    Joint {
        /// The robot.
        robot: String,
        /// The joint.
        joint: String,
        /// What is wrong, and what would be right.
        problem: String,
    },
    /// A joint on the way has six freedoms.
    #[error("joint `{joint}` floats; a chain needs one that holds, such as `fixed`")]
    Floating {
        /// The joint.
        joint: String,
    },
    /// A joint mimics what it cannot.
    #[error("joint `{joint}` mimics {problem}; name a joint with a value of its own")]
    Mimic {
        /// The joint.
        joint: String,
        /// What it mimics.
        problem: String,
    },
    /// The chosen tip is no body.
    #[error("there is no link `{tip}`; the tips are {tips}")]
    Tip {
        /// What was chosen.
        tip: String,
        /// The tips there are.
        tips: String,
    },
    /// No tip was chosen of several.
    #[error("the robot has several tips; choose one of {tips}")]
    Tips {
        /// The tips.
        tips: String,
    },
}
