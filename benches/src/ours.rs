//! Which of this library's types are measured, and how they are made of the data.

pub mod conformal;
pub mod euclidean;
pub mod plane_based;
