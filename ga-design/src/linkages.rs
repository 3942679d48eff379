//! Linkages and arms (chapter 4): bodies that joints hold together, and where they can be.
//!
//! ```text
//! Frame ── Link ── Joint ── Frame ── Link ── …
//!            └──────┴──► Chain ──► poses, screws ──► PoseSolver
//!            └──────┴──► ClosedLoop ──► states, mobility, motion
//! ```
//!
//! Every pose is a unit motor. A joint moves along its own z-axis or turns about it, whatever the
//! convention of the table that it was read from.

mod bennett;
mod chain;
mod closed_loop;
mod denavit_hartenberg;
mod frame;
mod joint;
mod link;
mod pose_solver;
mod target;
mod tree;

pub use bennett::Bennett;
pub use chain::{Chain, ChainError, Coupling, JointValue, Segment};
pub use closed_loop::{
    CLOSED, ClosedLoop, LoopError, LoopState, MOST_LINKS, Mobility, Motion, Turn,
};
pub use denavit_hartenberg::{Convention, Row, Table, TableError};
pub use frame::{Axis, Frame};
pub use joint::{Freedom, Joint, JointKind, Limits};
pub use link::Link;
pub use pose_solver::{PoseSolver, Solution};
pub use target::{Attitude, Miss, Target};
pub use tree::{Tree, TreeError};
