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

/// The same with four coefficients at a time, which are independent of each other: of many
/// coefficients the sum is ready in half the time. For arguments far from zero, too: neighbours
/// cancel first, unlike even and odd powers.
#[inline(always)]
pub(super) fn by_fours<L: Lanes>(x: L, coefficients: &[L::Float]) -> L {
    let Some(last) = coefficients.len().checked_sub(1) else {
        return L::ZERO;
    };
    let square = x * x;
    let fourth = square * square;
    let mut position = last / 4 * 4;
    let mut sum = at_most_four(x, square, &coefficients[position..]);
    while position > 0 {
        position -= 4;
        let own = &coefficients[position..position + 4];
        sum = at_most_four(x, square, own).plus_product(sum, fourth);
    }
    sum
}

/// The polynomial with up to four coefficients.
#[inline(always)]
fn at_most_four<L: Lanes>(x: L, square: L, coefficients: &[L::Float]) -> L {
    match coefficients {
        [] | [_] | [_, _] => line(x, coefficients),
        [_, _, high @ ..] => line(x, coefficients).plus_product(square, line(x, high)),
    }
}

/// The polynomial with the first two coefficients.
#[inline(always)]
fn line<L: Lanes>(x: L, coefficients: &[L::Float]) -> L {
    match coefficients {
        [] => L::ZERO,
        [constant] => L::splat(*constant),
        [constant, slope, ..] => L::splat(*constant).plus_product(x, L::splat(*slope)),
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
