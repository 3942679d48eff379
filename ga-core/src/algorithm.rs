//! Algorithms on whole algebras, written once over the traits that generated types implement:
//! generated code calls them with its own types.

mod exponential;
mod inverse;
mod inverse_scaling;
mod logarithm;
mod normalise;
mod parts;
mod principal_root;
mod separation;
mod series;
mod split;
mod square_root;
mod study;

pub use exponential::bivector_exponential;
pub use inverse::{adjugate, adjugate_products};
pub use inverse_scaling::{
    MOST_ROOTS, logarithm_products, principal_logarithm, principal_square_root,
    square_root_products,
};
pub use logarithm::{
    logarithm, logarithm_of_unit, motor_factor, motor_logarithm, motor_logarithm_apart,
};
pub(crate) use normalise::rounding_of;
pub use normalise::{Commutators, over_norm, renormalise};
pub use parts::{Bivectors, Fourvectors, Parts, Versors};
pub use principal_root::{Evens, MOST_STEPS, step_products};
pub use series::{MOST_HALVINGS, MOST_TERMS, ORTHONORMAL_TERMS, exponential};
pub use split::{Split, split};
pub use square_root::square_root;
pub use study::Study;
