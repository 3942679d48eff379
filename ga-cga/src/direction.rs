//! Directions: attitudes without a place, blades of the form **A**∧n_∞ (Table 2.6).
//!
//! A direction is where a flat element meets infinity: parallel lines share their
//! [`DirectionVector`], parallel planes their [`DirectionBivector`]. Translations leave
//! directions as they are.
//!
//! ```
//! use ga_cga::{DirectionVector, Line, Point, Translator, Vector3};
//!
//! let east = Vector3::new(1.0, 0.0, 0.0);
//! let line = Line::along(Point::at(0.0, 2.0, 5.0), east);
//! assert_eq!(line.attitude(), DirectionVector::along(east));
//! let moved = Translator::by(Vector3::new(3.0, 4.0, 5.0)).apply(line.attitude());
//! assert_eq!(moved.vector(), east);
//! ```

mod bivector;
mod trivector;
mod vector;

use crate::cga3::{DirectionBivector, DirectionTrivector, DirectionVector};

/// A direction of any grade.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Direction<T> {
    /// A multiple of n_∞ itself, the point at infinity that all flats share; with its weight.
    Infinity(T),
    /// The direction of lines.
    Vector(DirectionVector<T>),
    /// The direction of planes.
    Bivector(DirectionBivector<T>),
    /// The direction of space.
    Trivector(DirectionTrivector<T>),
}
