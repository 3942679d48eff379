//! The conformal algebra, with the motor a unit versor.

use crate::data::Motion;
use crate::ours::unit;
use ga_core::Real;

ga_macros::define_algebra! {
    pub mod algebra: R4_1 {
        basis { e1, e2, e3, no, ni }
        metric { e1^2 = 1, e2^2 = 1, e3^2 = 1, no.ni = -1 }
        types {
            /// A point of weight 1.
            Point { no = 1, e1, e2, e3, ni }
            /// A dual sphere.
            DualSphere { no, e1, e2, e3, ni }
            /// A dual plane.
            DualPlane { e1, e2, e3, ni }
            /// A point pair.
            PointPair = grade 2;
            /// A circle.
            Circle = grade 3;
            /// A line.
            Line { e12^ni, e13^ni, e23^ni, e1^no^ni, e2^no^ni, e3^no^ni }
            /// A sphere.
            Sphere = grade 4;
            /// A rotation.
            #[unit]
            Rotor { 1, e12, e13, e23 }
            /// A translation.
            #[unit]
            Translator { 1 = 1, e1^ni, e2^ni, e3^ni }
            /// A rigid motion.
            #[unit]
            Motor { 1, e12, e13, e23, e1^ni, e2^ni, e3^ni, e123^ni }
            /// An inversion, a translation and the inversion back.
            #[unit]
            Transversor { 1 = 1, e1^no, e2^no, e3^no }
            /// Any even versor.
            #[unit]
            Versor { 1, e12, e13, e23, e1^no, e2^no, e3^no, e1^ni, e2^ni, e3^ni, no^ni, e123^no, e123^ni, e12^no^ni, e13^no^ni, e23^no^ni }
        }
    }
}
pub use algebra::*;

/// The motor of a motion, a translator times a rotor.
pub fn motor<T: Real>(motion: &Motion) -> Motor<T> {
    let [w, x, y, z] = motion.rotation.map(T::from_f64);
    let [a, b, c] = motion.translation.map(|t| T::from_f64(-0.5 * t));
    unit(Translator::new(a, b, c) * Rotor::new(w, -z, y, -x))
}

/// A motion and the transversor of a vector.
pub fn versor<T: Real>((motion, x): (&Motion, &[f64; 3])) -> Versor<T> {
    let [x, y, z] = x.map(T::from_f64);
    unit((motor(motion) * Transversor::new(x, y, z)).into())
}

/// A point.
pub fn point<T: Real>(x: &[f64; 3]) -> Point<T> {
    let square = x.iter().map(|x| x * x).sum::<f64>();
    let [x, y, z] = x.map(T::from_f64);
    Point::new(x, y, z, T::from_f64(0.5 * square))
}

/// A dual plane.
pub fn plane<T: Real>(plane: &[f64; 4]) -> DualPlane<T> {
    let [a, b, c, d] = plane.map(T::from_f64);
    DualPlane::new(a, b, c, d)
}

/// A dual sphere about a point, with the first coordinate of another for its squared radius.
pub fn sphere<T: Real>((x, [radius, ..]): (&[f64; 3], &[f64; 3])) -> DualSphere<T> {
    let Point { e1, e2, e3, ni } = point(x);
    DualSphere::new(T::ONE, e1, e2, e3, ni - T::from_f64(*radius))
}

/// A circle through three points.
pub fn circle<T: Real>([x, y, z]: [&[f64; 3]; 3]) -> Circle<T> {
    point(x) ^ point(y) ^ point(z)
}

/// A line through two points.
pub fn line<T: Real>((x, y): (&[f64; 3], &[f64; 3])) -> Line<T> {
    let infinity = DualPlane::new(T::ZERO, T::ZERO, T::ZERO, T::ONE);
    ga_core::convert::pick(point(x) ^ point(y) ^ infinity)
}

/// A versor with all 32 coefficients stored, and some of the odd ones not zero.
pub fn dense<T: Real>((versor, x): (&Versor<T>, &[f64; 3])) -> Multivector<T> {
    Multivector::from(*versor) + DualSphere::from(point(x))
}
