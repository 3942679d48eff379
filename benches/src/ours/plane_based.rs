//! R3,0,1: planes, lines, points and their motors.

use ga_core::{Real, Unit};
pub use ga_spaces::plane_based3::{Line, Motor, Plane, Point, Rotor, Translator};

use crate::data::Motion;

/// The exponential of a line.
#[inline(always)]
pub fn screw<T: Real>(line: Line<T>) -> Motor<T> {
    Motor::screw(line)
}

/// The motor of a motion, a translator times a rotor.
pub fn motor<T: Real>(motion: &Motion) -> Unit<Motor<T>> {
    let [w, x, y, z] = motion.rotation.map(T::from_f64);
    let [a, b, c] = motion.translation.map(|t| T::from_f64(-0.5 * t));
    Unit::promised(Translator::new(a, b, c) * Rotor::new(w, -x, -y, -z))
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
