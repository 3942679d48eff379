//! R4,1: points, circles, spheres and their motors and versors.

pub use ga_cga::{
    Circle, DualPlane, DualSphere, Even, Line, Motor, Multivector, Point, Rotor, Translator,
    Transversor,
};
use ga_core::{Real, Unit};

use crate::data::Motion;

/// The motor of a motion, a translator times a rotor.
pub fn motor<T: Real>(motion: &Motion) -> Unit<Motor<T>> {
    let [w, x, y, z] = motion.rotation.map(T::from_f64);
    let [a, b, c] = motion.translation.map(|t| T::from_f64(-0.5 * t));
    Unit::promised(Translator::new(a, b, c) * Rotor::new(w, -z, y, -x))
}

/// A motion and the transversor of a vector.
pub fn versor<T: Real>((motion, x): (&Motion, &[f64; 3])) -> Unit<Even<T>> {
    let [x, y, z] = x.map(T::from_f64);
    Unit::promised(Even::from(motor(motion).into_inner()) * Transversor::new(x, y, z))
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
pub fn dense<T: Real>((versor, x): (&Unit<Even<T>>, &[f64; 3])) -> Multivector<T> {
    Multivector::from(versor.into_inner()) + DualSphere::from(point(x))
}
