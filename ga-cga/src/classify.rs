//! What a multivector is, decided from its coefficients.
//!
//! Computed elements need not be what their type says: the meet of two spheres is stored as a
//! [`Circle`](crate::Circle), but it is a tangent where they touch, an imaginary circle where they miss each
//! other, a flat point where they are concentric. [`classify`] tells, for every blade of every
//! grade, and hands out the element in the type that it deserves.
//!
//! ```
//! use ga_cga::{Classification, DualSphere, Flat, Point, Round, Shape, classify};
//!
//! let sphere = |x: f64| DualSphere::about(Point::at(x, 0.0, 0.0), 1.0);
//! let meet = |x: f64| classify((sphere(0.0) ^ sphere(x)).undual());
//! assert!(matches!(meet(1.0), Classification::Direct(Shape::RealRound(Round::Circle(_)))));
//! assert!(matches!(meet(2.0), Classification::Direct(Shape::Tangent(_))));
//! assert!(matches!(meet(3.0), Classification::Direct(Shape::ImaginaryRound(Round::Circle(_)))));
//! assert_eq!(meet(0.0), Classification::Zero);
//! let planes = classify((sphere(0.0) - sphere(1.0)) ^ (sphere(0.0) - sphere(2.0)));
//! assert!(matches!(planes, Classification::Direct(Shape::Direction(_))));
//! ```
//!
//! # How it is decided
//! A blade X is told by whether n_∞ is in it (n_∞∧X = 0) and whether it is at right angles to it
//! (n_∞⌋X = 0): both, a direction; the first, a flat; the second, the dual of a flat; neither,
//! a round or its dual, and then the sign of the squared radius decides. The same blade can be
//! read as direct or as dual element: a point pair is also the dual of an imaginary circle.
//! [`classify`] takes the reading of Table 2.6 (vectors are dual, all that can be direct is);
//! [`classify_dual`] takes the other one.
//!
//! The 32 basis blades are examples of all of it (Table 2.5), with i ≠ j from 1, 2, 3:
//!
//! | grade | round or tangent | flat | dual of a flat | direction |
//! |---|---|---|---|---|
//! | 0 | | | 1, of space | |
//! | 1 | n_o, the point at the origin | | eᵢ, of a plane | n_∞, infinity |
//! | 2 | eᵢn_o, a tangent vector | E, a flat point | eᵢⱼ, of a line | eᵢn_∞, of lines |
//! | 3 | eᵢⱼn_o, a tangent bivector | eᵢE, a line | e₁₂₃, of a flat point | eᵢⱼn_∞, of planes |
//! | 4 | e₁₂₃n_o, a tangent trivector | eᵢⱼE, a plane | | e₁₂₃n_∞, of space |
//! | 5 | | I = e₁₂₃E, space | | |
//!
//! # Tolerance
//! [`Tolerance`] has a relative part τ, 256 roundings by default (5.7e−14 in `f64`), and the
//! length that counts as ordinary, 1 by default. Multiplying an element by a number changes
//! nothing. Where elements were computed from much larger or more distant ones, give the size of
//! those as the length. With S the larger of that length and the distance and size of the element:
//! a round with |r²| ≤ τ S² is a tangent (a radius of 2.4e−7 at the origin, of 0.24 at a
//! distance of 10⁶); one with a radius above S/τ is flat; a flat farther than 1/τ lengths away
//! is a direction; a part that is not factorable, relative to the whole at the scale S, above τ
//! makes it no blade. Elements within 10⁶ lengths of the origin are told apart to that
//! precision.
//!
//! On SIMD lanes a condition holds when it holds in every lane; classify lanes one by one where
//! they differ.

pub(crate) mod decide;
pub(crate) mod range;
mod shape;
mod tolerance;

use ga_core::Real;

use crate::cga3::Multivector;

pub use shape::{Classification, Obstacle, Shape};
pub use tolerance::Tolerance;

/// What an element is, to the default tolerance.
///
/// ```
/// use ga_cga::{Classification, Line, Obstacle, Point, Rotor, Vector3, classify};
///
/// let p = Point::at(1.0, 2.0, 3.0);
/// assert_eq!(classify(p ^ p), Classification::Zero);
/// let mixed = Classification::NotABlade(Obstacle::MixedGrades);
/// assert_eq!(classify(Rotor::new(1.0, 1.0, 0.0, 0.0)), mixed);
/// let line = Line::along(p, Vector3::new(0.0, 0.0, 1.0));
/// assert_eq!(classify(line).line(), Some(line));
/// assert_eq!(classify(p * f64::NAN), Classification::NotFinite);
/// ```
pub fn classify<T: Real>(element: impl Into<Multivector<T>>) -> Classification<T> {
    classify_within(element, Tolerance::default())
}

/// What an element is, to a given tolerance.
pub fn classify_within<T: Real>(
    element: impl Into<Multivector<T>>,
    tolerance: Tolerance<T>,
) -> Classification<T> {
    decide::decide(element.into(), tolerance)
}

/// What an element is the dual of, to the default tolerance; what [`classify`] says where it
/// is the dual of nothing.
///
/// ```
/// use ga_cga::{Classification, Point, PointPair, Round, Shape, Vector3, classify_dual};
///
/// let pair = PointPair::about(Point::at(1.0, 0.0, 0.0), 4.0, Vector3::new(0.0, 1.0, 0.0));
/// let Classification::Dual(Shape::ImaginaryRound(Round::Circle(circle))) = classify_dual(pair)
/// else { panic!("Figure 2.12: a real pair is the dual of an imaginary circle") };
/// assert_eq!(circle.radius_squared(), Some(-4.0));
/// ```
pub fn classify_dual<T: Real>(element: impl Into<Multivector<T>>) -> Classification<T> {
    classify_dual_within(element, Tolerance::default())
}

/// What an element is the dual of, to a given tolerance; what [`classify_within`] says where
/// it is the dual of nothing.
pub fn classify_dual_within<T: Real>(
    element: impl Into<Multivector<T>>,
    tolerance: Tolerance<T>,
) -> Classification<T> {
    let element = element.into();
    match decide::decide(element.undual(), tolerance) {
        Classification::Direct(shape) => Classification::Dual(shape),
        Classification::Dual(_) | Classification::Number(_) => decide::decide(element, tolerance),
        none => none,
    }
}

/// The entry points as methods.
macro_rules! classify_methods {
    ($($Element:ident)*) => {$(
        impl<T: Real> crate::cga3::$Element<T> {
            /// What this element is, to the default tolerance; see [`classify()`].
            pub fn classify(self) -> Classification<T> {
                classify(self)
            }
        }
    )*};
}

classify_methods! {
    Scalar Vector3 Bivector3 Trivector3 Point DualSphere DualPlane PointPair FlatPoint
    DirectionVector TangentVector DualLine MinkowskiPlane Circle Line DirectionBivector
    TangentBivector Sphere Plane DirectionTrivector TangentTrivector Pseudoscalar Even Odd
    Multivector
}
