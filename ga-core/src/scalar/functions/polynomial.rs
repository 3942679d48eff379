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

/// The polynomial with the first coefficient and every other one from there; zero with none.
///
/// A loop, because lanes want no closure: it would not be inlined.
#[inline(always)]
fn every_other<L: Lanes>(square: L, coefficients: &[L::Float]) -> L {
    let mut own = coefficients.iter().step_by(2).rev();
    let Some(last) = own.next() else {
        return L::ZERO;
    };
    let mut sum = L::splat(*last);
    for coefficient in own {
        sum = L::splat(*coefficient).plus_product(sum, square);
    }
    sum
}
