//! Settings, positions, subperiodic groups and recognition, each against an independent program.

mod recognition;
mod settings;
mod subperiodic;
mod symbols;
mod wyckoff;
