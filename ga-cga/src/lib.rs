//! Conformal geometric algebra of Euclidean 3-space: points, spheres, planes and the motions
//! that move them, generated from one metric.
//!
//! A Euclidean point **x** is the null vector n_o + **x** + ½**x**² n_∞ (2.44). Inner products
//! of points are distances (2.46), outer products of points are circles, spheres and lines, and
//! every motion is a versor that [`apply`](cga3::Motor::apply)s to all of them alike.
//!
//! ```
//! use ga_cga::{Bivector3, Motor, Point, Rotor, Translator, Vector3};
//!
//! let p = Point::at(1.0, 0.0, 0.0);
//! let quarter = Rotor::turn(Bivector3::new(1.0, 0.0, 0.0), core::f64::consts::FRAC_PI_2);
//! let up = Translator::by(Vector3::new(0.0, 0.0, 2.0));
//! let screw: Motor = up * quarter.unwrap();
//! let q: Point = screw.apply(p);
//! assert!((q.position() - Vector3::new(0.0, 1.0, 2.0)).norm() < 1e-15);
//!
//! let circle = Point::at(1.0, 0.0, 0.0) ^ Point::at(0.0, 1.0, 0.0) ^ Point::at(-1.0, 0.0, 0.0);
//! assert!((Point::at(0.0, -1.0, 0.0) ^ circle).norm() < 1e-15);
//! ```
//!
//! Accuracy: coefficients are stored in the null basis, where the coordinates of a point keep
//! full precision at any distance from the origin.

#![no_std]

mod algebra;
pub mod classify;
pub mod direction;
pub mod flat;
pub mod incidence;
pub mod interop;
pub mod round;
pub mod tangent;
mod versor;

pub use algebra::cga3;
pub use algebra::cga3::*;
pub use classify::{
    Classification, Obstacle, Shape, Tolerance, classify, classify_dual, classify_dual_within,
    classify_within,
};
pub use direction::Direction;
pub use flat::Flat;
pub use round::{CircleOrLine, Degenerate, Round, SphereOrPlane, SplitPair};
pub use tangent::Tangent;
