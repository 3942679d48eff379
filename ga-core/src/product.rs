//! The products of geometric algebra, one table row each, on basis blades of any metric.

mod expansion;
mod table;

use alloc::vec;
use alloc::vec::Vec;

pub use table::{Product, Row, Rule, TABLE};

use crate::dual::{left_complement, right_complement};
use crate::{Blade, Metric, Rational, reorder_sign};

/// The geometric product of two basis blades: its terms in blade order, none of them zero.
///
/// Each basis blade is the *outer* product of its vectors, also where they are not orthogonal.
/// `None` if an intermediate result overflows 128-bit fractions or a blade has vectors beyond
/// the metric's dimension.
///
/// ```
/// use ga_core::product::geometric;
/// use ga_core::{Blade, Metric, Rational};
///
/// let metric = Metric::from_signature(2, 0, 0)?;
/// let e12 = Blade::new(0b11);
/// assert_eq!(geometric(&metric, e12, e12), Some(vec![(Blade::SCALAR, Rational::from_integer(-1))]));
/// # Ok::<(), ga_core::MetricError>(())
/// ```
pub fn geometric(metric: &Metric, a: Blade, b: Blade) -> Option<Vec<(Blade, Rational)>> {
    product(metric, Product::Geometric, a, b)
}

/// Any product of two basis blades: its terms in blade order, none of them zero.
///
/// `None` under the conditions of [`geometric`].
///
/// ```
/// use ga_core::product::product;
/// use ga_core::{Blade, Metric, Product, Rational};
///
/// let metric = Metric::from_signature(3, 0, 0)?;
/// let terms = product(&metric, Product::LeftContract, Blade::new(0b001), Blade::new(0b011));
/// assert_eq!(terms, Some(vec![(Blade::new(0b010), Rational::from_integer(1))]));
/// # Ok::<(), ga_core::MetricError>(())
/// ```
pub fn product(
    metric: &Metric,
    which: Product,
    a: Blade,
    b: Blade,
) -> Option<Vec<(Blade, Rational)>> {
    if !metric.contains(a) || !metric.contains(b) {
        return None;
    }
    match which.row().rule {
        Rule::Grades(keep) => expansion::terms(metric, a, b, keep),
        Rule::Complements => Some(regressive(metric.dimension(), a, b)),
    }
}

/// The complement of the outer product of the complements; no metric takes part.
fn regressive(dimension: usize, a: Blade, b: Blade) -> Vec<(Blade, Rational)> {
    let (a, a_sign) = right_complement(dimension, a);
    let (b, b_sign) = right_complement(dimension, b);
    if a.mask() & b.mask() != 0 {
        return Vec::new();
    }
    let wedge_sign = reorder_sign(a.mask(), b.mask());
    let (result, sign) = left_complement(dimension, Blade::new(a.mask() | b.mask()));
    let sign = sign * wedge_sign * a_sign * b_sign;
    vec![(result, Rational::from_integer(i128::from(sign)))]
}
