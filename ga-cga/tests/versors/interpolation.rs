//! Interpolation between versors and between elements (2.66–2.70), both ways.

mod elements;
mod finite;
mod law;
mod orientation;
mod refusals;
mod tangents;
mod versors;
