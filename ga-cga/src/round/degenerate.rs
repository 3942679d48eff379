//! When points do not determine the element that is asked for.

use core::fmt;

use ga_core::Real;

use crate::cga3::Vector3;
use crate::classify::range::{larger, length};

/// Why there is no element through these points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Degenerate {
    /// Two of the points are the same to within the rounding of their coordinates.
    CoincidentPoints,
    /// The points are on one line, and a plane or a sphere through them is not unique.
    CollinearPoints,
    /// The four points are on one circle, and a sphere through them is not unique.
    CocircularPoints,
    /// A coordinate is not finite, or the points are so far from the origin or so close to
    /// each other that the coefficients of their product are out of range.
    NotFinite,
}

impl fmt::Display for Degenerate {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Degenerate::CoincidentPoints => "two of the points coincide",
            Degenerate::CollinearPoints => "the points are on one line",
            Degenerate::CocircularPoints => "the points are on one circle",
            Degenerate::NotFinite => "a coordinate is not finite or out of range",
        })
    }
}

impl core::error::Error for Degenerate {}

/// How far rounded coordinates and short computations with them are trusted, in units of the
/// last place.
const ROUNDING: i64 = 16;

/// The rounding of positions of this size.
pub(super) fn rounding<T: Real>(size: T) -> T {
    size * T::EPSILON * T::from_integer(ROUNDING)
}

/// Whether a product of lengths is so small that its rounding is out of range.
pub(crate) fn underflows<T: Real>(product: T) -> bool {
    !(product * T::EPSILON).is_invertible()
}

/// Whether two positions are the same to within rounding.
pub(crate) fn coincide<T: Real>(a: Vector3<T>, b: Vector3<T>) -> bool {
    length(a - b).all_le(rounding(larger(length(a), length(b))))
}

/// Whether three positions are on one line to within rounding.
pub(crate) fn collinear<T: Real>(a: Vector3<T>, b: Vector3<T>, c: Vector3<T>) -> bool {
    let (u, v) = (b - a, c - a);
    let (u_length, v_length) = (length(u), length(v));
    let away = larger(larger(length(a), length(b)), length(c));
    // The area is uncertain by the rounding of the product and by that of the differences.
    let uncertain = rounding(u_length) * v_length + rounding(away) * (u_length + v_length);
    length(u.wedge(v)).all_le(uncertain)
}
