//! Settings, positions, subperiodic groups and recognition, each against an independent program.

mod settings;
mod wyckoff;
