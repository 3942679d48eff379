//! Conformal geometric algebra of Euclidean 3-space.

mod algebra;

pub use algebra::cga3;
