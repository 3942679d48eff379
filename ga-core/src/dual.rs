//! Complements and duals of basis blades.
//!
//! The complements need no metric and always exist; the dual divides by the pseudoscalar and
//! exists where the metric is not degenerate.

use alloc::vec::Vec;

use num_traits::{CheckedDiv, CheckedMul};

use crate::product::geometric;
use crate::{Blade, Involution, Metric, Rational, reorder_sign};

/// The blade and sign with e_S ∧ right_complement(e_S) = I in `dimension` dimensions. Basis
/// vectors beyond the dimension are ignored.
///
/// ```
/// use ga_core::{Blade, dual::right_complement};
///
/// assert_eq!(right_complement(3, Blade::new(0b010)), (Blade::new(0b101), -1)); // e2: −e13
/// ```
pub const fn right_complement(dimension: usize, blade: Blade) -> (Blade, i32) {
    let (blade, rest) = split(dimension, blade);
    (Blade::new(rest), reorder_sign(blade, rest))
}

/// The blade and sign with left_complement(e_S) ∧ e_S = I in `dimension` dimensions. Basis
/// vectors beyond the dimension are ignored.
///
/// ```
/// use ga_core::{Blade, dual::left_complement};
///
/// assert_eq!(left_complement(2, Blade::new(0b01)), (Blade::new(0b10), -1)); // e1: −e2
/// ```
pub const fn left_complement(dimension: usize, blade: Blade) -> (Blade, i32) {
    let (blade, rest) = split(dimension, blade);
    (Blade::new(rest), reorder_sign(rest, blade))
}

/// The vectors of `blade` within the dimension, and the others.
const fn split(dimension: usize, blade: Blade) -> (u32, u32) {
    let all = Blade::pseudoscalar(dimension).mask();
    (all & blade.mask(), all & !blade.mask())
}

/// The dual e I⁻¹ of a basis blade, its terms in blade order.
///
/// `None` if the metric is degenerate, if the arithmetic overflows, or if the blade has vectors
/// beyond the metric's dimension.
///
/// ```
/// use ga_core::{Blade, Metric, Rational, dual::dual};
///
/// let metric = Metric::from_signature(3, 0, 0)?;
/// let e12 = Blade::new(0b011);
/// assert_eq!(dual(&metric, e12), Some(vec![(Blade::new(0b100), Rational::from_integer(1))]));
/// # Ok::<(), ga_core::MetricError>(())
/// ```
pub fn dual(metric: &Metric, blade: Blade) -> Option<Vec<(Blade, Rational)>> {
    if metric.is_degenerate() {
        return None;
    }
    let pseudoscalar = Blade::pseudoscalar(metric.dimension());
    let reversal = Involution::Reverse.sign(pseudoscalar.grade());
    let square = Rational::from_integer(i128::from(reversal)).checked_mul(&metric.determinant())?;
    undual(metric, blade)?
        .into_iter()
        .map(|(blade, coefficient)| Some((blade, coefficient.checked_div(&square)?)))
        .collect()
}

/// The inverse of the dual, e I, its terms in blade order; in a degenerate metric it exists but
/// is not invertible.
///
/// `None` if the arithmetic overflows or if the blade has vectors beyond the metric's dimension.
pub fn undual(metric: &Metric, blade: Blade) -> Option<Vec<(Blade, Rational)>> {
    geometric(metric, blade, Blade::pseudoscalar(metric.dimension()))
}
