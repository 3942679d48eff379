//! Geometric algebra with nothing left to run time, and the geometry that stands on it.
//!
//! [`define_algebra!`] turns a metric into plain structs with unrolled, simplified products.
//! [`cga`] is the conformal model of Euclidean 3-space generated this way, [`design`] makes
//! structures with it, and [`core`] holds the mathematics of blades that both stand on. With the
//! feature `lanes`, `ga::lanes` computes batches of elements at the speed of the machine.
//!
//! ```
//! ga::define_algebra!(R3);
//! use r3::Vector;
//!
//! let a = Vector::new(1.0, 2.0, 3.0);
//! let b = Vector::new(4.0, 5.0, 6.0);
//! assert_eq!((a ^ b).to_string(), "-3 e12 - 6 e13 - 3 e23");
//! assert_eq!((a | b).to_string(), "32");
//! ```

#![no_std]

#[cfg(feature = "cga")]
#[doc(inline)]
pub use ga_cga as cga;
#[doc(inline)]
pub use ga_core as core;
#[cfg(feature = "design")]
#[doc(inline)]
pub use ga_design as design;
#[cfg(feature = "lanes")]
#[doc(inline)]
pub use ga_lanes as lanes;
#[cfg(feature = "spaces")]
#[doc(inline)]
pub use ga_spaces as spaces;

#[doc(hidden)]
pub use ga_macros as __macros;

/// Declares a geometric algebra: a signature such as `R4_1`, or a module with a basis, a
/// metric, types and products of its own.
///
/// ```
/// ga::define_algebra! {
///     /// Plane-based geometric algebra of the Euclidean plane.
///     pub mod pga2: R2_0_1 {
///         basis { e1, e2, e0 }
///         metric { e1^2 = 1, e2^2 = 1 }
///         types {
///             /// A line a x + b y + c = 0.
///             Line { e1, e2, e0 }
///             /// A point, dual to its coordinates.
///             Point { e12 = 1, e20, e01 }
///         }
///     }
/// }
///
/// let x_axis = pga2::Line::new(0.0, 1.0, 0.0);
/// let diagonal = pga2::Line::new(1.0, -1.0, 0.0);
/// let origin = x_axis ^ diagonal;
/// assert_eq!(origin.to_string(), "-1 e12");
/// ```
#[macro_export]
macro_rules! define_algebra {
    ($($tokens:tt)*) => {
        $crate::__macros::define_algebra! { crate = $crate::core; $($tokens)* }
    };
}

/// The expansion of [`define_algebra!`] with the same body, as formatted Rust in a
/// `&'static str`: a crate can hold a snapshot of its own algebra.
///
/// ```
/// let source: &'static str = ga::algebra_source!(R2);
/// assert!(source.contains("pub struct Bivector<T = f64>"));
/// ```
#[macro_export]
macro_rules! algebra_source {
    ($($tokens:tt)*) => {
        $crate::__macros::algebra_source! { $($tokens)* }
    };
}

/// What most programs want in scope: the number traits and the traits of generic code.
pub mod prelude {
    pub use crate::core::ops::*;
    pub use crate::core::{Blade, Field, Real, Scalar, Unit};
    #[cfg(feature = "lanes")]
    pub use crate::lanes::{Batch, One};
    pub use crate::{algebra_source, define_algebra};
}

/// The examples of the README, as tests.
#[cfg(all(doctest, feature = "design"))]
#[doc = include_str!("../README.md")]
pub struct Readme;
