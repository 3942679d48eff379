//! Interpolation between versors and between elements (2.66–2.70), both ways.

#[path = "../versors/random.rs"]
mod random;

mod elements;
mod versors;
