//! The plane-based algebra, with the motor a unit versor.

use crate::data::Motion;
use crate::ours::unit;
use ga_core::Real;

ga_macros::define_algebra! {
    pub mod algebra: R3_0_1 {
        basis { e0, e1, e2, e3 }
        metric { e1^2 = 1, e2^2 = 1, e3^2 = 1 }
        types {
            /// A plane.
            Plane { e1, e2, e3, e0 }
            /// A line.
            Line { e23, e31, e12, e01, e02, e03 }
            /// A point of weight 1.
            Point { e123 = 1, e032, e013, e021 }
            /// A direction.
            Direction { e032, e013, e021 }
            /// A point with a weight.
            WeightedPoint { e123, e032, e013, e021 }
            /// A rotation.
            #[unit]
            Rotor { 1, e23, e31, e12 }
            /// A translation.
            #[unit]
            Translator { 1 = 1, e01, e02, e03 }
            /// A rigid motion.
            #[unit]
            Motor { 1, e23, e31, e12, e01, e02, e03, e0^e123 }
            /// The pseudoscalar.
            Pseudoscalar { e0^e123 }
        }
    }
}
pub use algebra::*;

/// The exponential of a line.
pub fn screw<T: ga_core::Real>(line: Line<T>) -> Motor<T> {
    ga_core::convert::pick(line.exp())
}

/// The motor of a motion, a translator times a rotor.
pub fn motor<T: Real>(motion: &Motion) -> Motor<T> {
    let [w, x, y, z] = motion.rotation.map(T::from_f64);
    let [a, b, c] = motion.translation.map(|t| T::from_f64(-0.5 * t));
    unit(Translator::new(a, b, c) * Rotor::new(w, -x, -y, -z))
}

/// A point.
pub fn point<T: Real>(x: &[f64; 3]) -> Point<T> {
    let [x, y, z] = x.map(T::from_f64);
    Point::new(x, y, z)
}

/// The line through two points.
pub fn line<T: Real>((x, y): (&[f64; 3], &[f64; 3])) -> Line<T> {
    point(x) & point(y)
}

/// A plane.
pub fn plane<T: Real>(plane: &[f64; 4]) -> Plane<T> {
    let [a, b, c, d] = plane.map(T::from_f64);
    Plane::new(a, b, c, d)
}
