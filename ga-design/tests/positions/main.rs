//! Settings, positions, subperiodic groups and recognition, each against an independent program.

mod hostile;
mod notes;
mod orbifolds;
mod recognition;
mod settings;
mod structures;
mod subperiodic;
mod subperiodic_symbols;
mod subperiodic_wyckoff;
mod symbols;
mod wyckoff;
