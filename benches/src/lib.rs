//! What the measurements have in common: clocks, builds for different targets, tables.

pub mod race;
