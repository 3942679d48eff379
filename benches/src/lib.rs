//! What the measurements have in common: data, clocks, builds for different targets.

pub mod builds;
pub mod data;
pub mod declarations;
pub mod ours;
pub mod race;
