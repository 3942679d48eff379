//! In which order the terms of a polynomial are summed.

use crate::scalar::lanes::Lanes;

/// The polynomial with these coefficients, the constant one first: even and odd powers by Horner's
/// scheme side by side, so that two sums advance at a time.
#[inline(always)]
pub(super) fn polynomial<L: Lanes>(x: L, coefficients: &[L::Float]) -> L {
    let square = x * x;
    let sum = |first: usize| {
        let own = coefficients.iter().skip(first).step_by(2).rev();
        own.fold(None, |sum: Option<L>, &coefficient| {
            let term = L::splat(coefficient);
            Some(sum.map_or(term, |sum| term.plus_product(sum, square)))
        })
    };
    match (sum(0), sum(1)) {
        (Some(even), Some(odd)) => even.plus_product(odd, x),
        (Some(even), None) => even,
        _ => L::ZERO,
    }
}
