//! Every generated operation of every pair of types against the dense multivectors of ga-core,
//! exactly, over rational numbers.

#[macro_use]
mod each;

mod arithmetic;
mod conformal;
mod conversions;
mod divisions;
mod kind;
mod laws;
#[path = "../metrics/conformal.rs"]
mod metrics;
mod nine_dimensions;
mod null;
mod oblique;
mod operation;
mod operators;
mod polynomial;
mod presets;
mod products;
mod reference;
mod result_types;
mod samples;
mod scalars;
mod six_dimensions;
mod transcendental;
mod twelve_dimensions;
mod unary;
mod versors;
