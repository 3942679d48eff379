//! The exponential function: eˣ = 2ⁿ eʳ with |r| ≤ ln 2/2.

use super::polynomial::polynomial;
use super::{constant, nearest_integer};
use crate::scalar::lanes::Lanes;
use crate::scalar::precision::Precision;

/// eˣ; infinite and zero where it leaves the range of the numbers.
#[cfg_attr(not(all(feature = "inlined", not(debug_assertions))), inline)]
#[cfg_attr(all(feature = "inlined", not(debug_assertions)), inline(always))]
pub fn exp<L: Lanes>(x: L) -> L {
    scaled(x, L::ZERO)
}

/// eˣ/2, which is finite somewhat longer.
#[inline(always)]
pub(super) fn half_exp<L: Lanes>(x: L) -> L {
    scaled(x, -L::ONE)
}

/// eˣ 2ⁿ.
#[inline(always)]
fn scaled<L: Lanes>(x: L, power: L) -> L {
    let end = L::splat(L::Float::ENDLESS);
    let x = L::select(end.is_less(x), end, x);
    let x = L::select(x.is_less(-end), -end, x);
    let [high, low] = L::Float::LN_2;
    let n = nearest_integer(x * constant(core::f64::consts::LOG2_E));
    let r = x.minus_product(n, L::splat(high));
    let r = r.minus_product(n, L::splat(low));
    let rest = r.plus_product(r * r, polynomial(r, L::Float::EXPONENTIAL));
    let power = n + power;
    // In two steps: 2ⁿ need not be a number where eˣ is one.
    let half = nearest_integer(power * constant(0.5));
    (rest + L::ONE) * half.power_of_two() * (power - half).power_of_two()
}
