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
#![cfg_attr(doc, doc = include_str!("../pictures/covariance.md"))]
//!
//! # The elements, from the ground up
//! **A point is a vector that squares to zero**, and a vector that does not is a sphere with its
//! squared radius in the square ([`round`]). Spheres and planes ([`DualSphere`], [`DualPlane`])
//! are the mirrors that everything else is made of.
//!
//! **The outer product spans.** Two points span a pair, three a circle, four a sphere; with the
//! point at infinity n_∞ among them, a flat point, a line, a plane ([`flat`]). The product of
//! points that coincide or are in line says so: constructors answer with what the points do
//! determine.
//!
//! ```
//! use ga_cga::{Circle, Point, Vector3};
//!
//! let [a, b, c] = [Point::at(3.0, 0.0, 1.0), Point::at(0.0, 3.0, 1.0), Point::at(-3.0, 0.0, 1.0)];
//! let circle = Circle::through(a, b, c).unwrap().circle().unwrap();
//! assert_eq!(circle.center(), Some(Point::at(0.0, 0.0, 1.0)));
//! assert_eq!(circle.radius_squared(), Some(9.0));
//! ```
//!
//! **Duals describe the same element by what is at right angles to it.** The dual A* = A I⁻¹ of a
//! sphere is the vector that names its centre; the dual of a line generates the rotations about
//! it. Products of duals intersect, (A*∧B*)⁻* (2.25), and [`incidence::meet`] does it for any two
//! elements.
//!
//! **What remains when a round shrinks is a tangent** ([`tangent`]), what remains of a flat when
//! its place is forgotten is a [`direction`]; circles and spheres whose squared radius is
//! negative are imaginary and take part in all of it. [`classify()`] says which of these a
//! computed element really is.
//!
//! ```
//! use ga_cga::{Classification, DualSphere, Shape, Tangent, Vector3, incidence::meet};
//!
//! let [left, right] = [-2.0, 2.0].map(|x| DualSphere::with_radius(Vector3::new(x, 0.0, 0.0), 2.0));
//! let Classification::Direct(Shape::Tangent(Tangent::Bivector(touch))) = meet(left, right) else {
//!     panic!("the spheres touch")
//! };
//! assert_eq!(touch.center().unwrap().position(), Vector3::new(0.0, 0.0, 0.0));
//! ```
//!
//! **What moves is a versor**: a product of vectors, applied alike to all of these elements.
//! [`versor`] says which versor does what and of which type a product of two is, and
//! [`interpolate`] finds the way between two of them, or between two elements.
//!
//! **Everything is measured by products**: distances and angles, projections and nearest points,
//! of any element and any other ([`incidence`]).
//!
//! Which blade of the 32 is what kind of element (Table 2.5) is said with each type of [`cga3`]
//! and in one table in [`classify`](mod@classify#how-it-is-decided); how points and motions go to
//! matrices, quaternions and other libraries and come back, in [`interop`].
//!
//! # Accuracy
//! Coefficients are stored in the null basis, where the coordinates of a point keep full
//! precision at any distance from the origin. What holds for the other elements is stated in
//! [`round`](round#accuracy-far-from-the-origin), for decisions in
//! [`classify`](mod@classify#tolerance) and [`incidence`]. Everything is generic over the number:
//! in single precision the same holds with its ε of 1.2e−7.

#![no_std]

mod algebra;
pub mod classify;
pub mod direction;
pub mod flat;
pub mod incidence;
pub mod interop;
pub mod interpolate;
pub mod round;
pub mod tangent;
pub mod versor;

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
pub use versor::{ConformalRotor, OddVersor};

pub use ga_core::Unit;
