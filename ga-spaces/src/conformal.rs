//! Rn+1,1, the conformal model of Euclidean space of any dimension: code that is written once
//! for n = 1 … 5.
//!
//! A position **x** is the null vector n_o + **x** + ½**x**² n_∞ (2.44), in every dimension. The
//! inner product of two points is −½ of their squared distance, a vector is a sphere of one
//! dimension less than the space, and reflections in vectors make all motions. [`Conformal<N>`]
//! is the model of dimension N; what holds in all of them is in [`ConformalSpace`], and the types
//! themselves, with all products between them, are in the modules `dimension1` … `dimension5`.
//!
//! ```
//! use ga_spaces::conformal::{Conformal, ConformalSpace};
//!
//! /// The distance of two positions after inversion in the unit sphere, in any dimension.
//! fn inverted<S: ConformalSpace<f64>>(a: S::Vector, b: S::Vector) -> Option<f64> {
//!     let unit = S::dual_sphere(S::point(S::Vector::default()), 1.0);
//!     let [a, b] = [a, b].map(|x| S::position(S::reflect(unit, S::point(x).into())?));
//!     Some(S::squared_distance(S::point(a?), S::point(b?)).sqrt())
//! }
//!
//! let (a, b) = ([2.0, 0.0, 0.0, 0.0].into(), [0.0, 0.0, 0.0, 2.0].into());
//! assert_eq!(inverted::<Conformal<4>>(a, b), Some(0.5_f64.sqrt()));
//! let (a, b) = ([2.0].into(), [-4.0].into());
//! assert_eq!(inverted::<Conformal<1>>(a, b), Some(0.75));
//! ```
//!
//! Source: §2.4 of the dissertation, in n dimensions; Li, Hestenes and Rockwood, *Generalized
//! homogeneous coordinates for computational geometry* (2001).

mod algebras;
mod space;

pub use algebras::{Conformal, dimension1, dimension2, dimension3, dimension4, dimension5};
pub use space::ConformalSpace;
