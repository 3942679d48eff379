//! How much rounding a decision forgives.

use ga_core::Real;

/// What counts as zero.
///
/// ```
/// use ga_cga::{DualSphere, Point, Shape, Tolerance, classify_within};
///
/// // A scene in nanometres, written in metres.
/// let small = DualSphere::about(Point::at(0.0, 0.0, 0.0), 1e-18);
/// let nanometres = Tolerance { length: 1e-9, ..Tolerance::default() };
/// assert!(classify_within(small, nanometres).is_real_round());
/// assert!(!classify_within(small, Tolerance::default()).is_real_round());
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tolerance<T> {
    /// The relative error τ of coefficients of equal dimension.
    pub relative: T,
    /// The length that counts as ordinary, the size of the scene: rounding is assumed to have
    /// happened to distances of this size even where those left over are smaller.
    pub length: T,
}

impl<T: Real> Default for Tolerance<T> {
    /// 256 spacings of the number type, and a length of 1.
    fn default() -> Self {
        Tolerance {
            relative: T::EPSILON * T::from_integer(256),
            length: T::ONE,
        }
    }
}

impl<T: Real> Tolerance<T> {
    /// A relative tolerance, at a length of 1.
    pub fn relative(relative: T) -> Self {
        Tolerance {
            relative,
            length: T::ONE,
        }
    }
}
