//! The natural logarithm: ln x = n ln 2 + ln m with √½ ≤ m < √2.

use super::polynomial::polynomial;
use super::{constant, is_not_a_number};
use crate::scalar::lanes::Lanes;
use crate::scalar::precision::Precision;

/// ln x; −∞ of zero, not a number of negative numbers.
#[cfg_attr(not(all(feature = "inlined", not(debug_assertions))), inline)]
#[cfg_attr(all(feature = "inlined", not(debug_assertions)), inline(always))]
pub fn ln<L: Lanes>(x: L) -> L {
    let (scale, exponent) = L::Float::NORMALISING;
    let subnormal = x.is_less(L::splat(L::Float::SMALLEST));
    let normal = L::select(subnormal, x * L::splat(scale), x);
    let (m, n) = normal.mantissa_and_exponent();
    let n = L::select(subnormal, n - L::splat(exponent), n);
    let above = constant::<L>(core::f64::consts::SQRT_2).is_less(m);
    let m = L::select(above, m * constant(0.5), m);
    let n = L::select(above, n + L::ONE, n);
    // With t = f/(2 + f) and m = 1 + f: ln m = 2 artanh t = f − f²/2 + t (f²/2 + R(t²)), where the
    // exact f carries the digits.
    let f = m - L::ONE;
    let t = f / (f + constant(2.0));
    let square = t * t;
    let half_square = f * f * constant(0.5);
    let rest = square * polynomial(square, L::Float::LOGARITHM);
    let [high, low] = L::Float::LN_2;
    let small = (n * L::splat(low)).plus_product(t, half_square + rest);
    let sum = (n * L::splat(high)) + (f - (half_square - small));
    let infinite = L::splat(L::Float::LARGEST).is_less(x) | is_not_a_number(x);
    let sum = L::select(infinite, x, sum);
    let positive = L::ZERO.is_less(x) | is_not_a_number(x);
    // −1/0 of zeros; 0/0 of negative numbers.
    let zero = x.is_at_most(L::ZERO) & L::ZERO.is_at_most(x);
    let beyond = L::select(zero, -L::ONE, L::ZERO) / L::ZERO;
    L::select(positive, sum, beyond)
}
