//! In which order the terms of a polynomial are summed.

use crate::scalar::lanes::Lanes;

/// The polynomial with these coefficients, the constant one first: even and odd powers by Horner's
/// scheme side by side, so that two sums advance at a time.
#[inline(always)]
pub(super) fn polynomial<L: Lanes>(x: L, coefficients: &[L::Float]) -> L {
    let square = x * x;
    let even = every_other(square, coefficients);
    match coefficients {
        [] | [_] => even,
        [_, odd @ ..] => even.plus_product(every_other(square, odd), x),
    }
}

/// The same for arguments far from zero, where even and odd powers would cancel: the two lowest
/// coefficients, which have the largest part in the sum, by Horner's scheme.
#[inline(always)]
pub(super) fn long_polynomial<L: Lanes>(x: L, coefficients: &[L::Float]) -> L {
    match coefficients {
        [first, second, others @ ..] => {
            let sum = L::splat(*second).plus_product(x, polynomial(x, others));
            L::splat(*first).plus_product(x, sum)
        }
        _ => polynomial(x, coefficients),
    }
}

/// The polynomial with the first coefficient and every other one from there; zero with none.
///
/// A loop over positions: closures would not be inlined into lanes, and loops over iterators of
/// every other element not be unrolled.
#[inline(always)]
fn every_other<L: Lanes>(square: L, coefficients: &[L::Float]) -> L {
    let Some(last) = coefficients.len().checked_sub(1) else {
        return L::ZERO;
    };
    let mut position = last / 2 * 2;
    let mut sum = L::splat(coefficients[position]);
    while position > 0 {
        position -= 2;
        sum = L::splat(coefficients[position]).plus_product(sum, square);
    }
    sum
}
