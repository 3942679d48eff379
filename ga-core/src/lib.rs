//! The mathematics of basis blades: metrics, products, duals and the numbers they are computed
//! in, without any geometry.

#![no_std]

extern crate alloc;
#[cfg(feature = "std")]
extern crate std;

pub mod algorithm;
mod blade;
pub mod convert;
pub mod dense;
pub mod dual;
mod implement;
mod involution;
mod length_mismatch;
pub mod linear_map;
pub mod matrix;
mod metric;
pub mod ops;
pub mod product;
mod rational;
mod scalar;
pub mod table;
mod unit;

pub use blade::{Blade, reorder_sign};
pub use convert::Narrowing;
#[doc(hidden)]
pub use implement::features::crates;
pub use involution::Involution;
pub use length_mismatch::LengthMismatch;
pub use linear_map::LinearMap;
pub use metric::{Metric, MetricError};
pub use ops::Element;
pub use product::Product;
pub use rational::Rational;
pub use scalar::{Computation, Dual, Field, Real, Scalar};
#[cfg(any(feature = "std", feature = "libm"))]
pub use scalar::{Lanes, Precision};
pub use unit::Unit;
