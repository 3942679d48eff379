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

pub use exponential::{bivector_exponential, motor_exponential};
pub use inverse::adjugate;
pub use inverse_scaling::{principal_logarithm, principal_square_root};
pub use logarithm::{logarithm, motor_logarithm};
pub(crate) use normalise::rounding_of;
pub use normalise::{Commutators, over_norm, renormalise};
pub use parts::{Bivectors, Fourvectors, Parts, Versors};
pub use principal_root::Evens;
pub use series::exponential;
pub use split::{Split, split};
pub use square_root::square_root;
pub use study::Study;
