//! Sine and cosine: by quarters of a turn from those of |r| ≤ π/4.

use super::polynomial::polynomial;
use super::{constant, nearest_integer, parity};
use crate::scalar::elementary::Elementary;
use crate::scalar::lanes::Lanes;
use crate::scalar::precision::Precision;

/// Sine and cosine of an angle in radians.
///
/// Angles of more than [`MOST_TURNS`](Precision::MOST_TURNS) quarters of a turn are left to the
/// library, lane by lane.
#[cfg_attr(not(all(feature = "inlined", not(debug_assertions))), inline)]
#[cfg_attr(all(feature = "inlined", not(debug_assertions)), inline(always))]
pub fn sin_cos<L: Lanes>(x: L) -> (L, L) {
    let turns = nearest_integer(x * constant(core::f64::consts::FRAC_2_PI));
    let near = turns.magnitude().is_at_most(L::splat(L::Float::MOST_TURNS));
    let turns = L::select(near, turns, L::ZERO);
    let parts = L::Float::HALF_PI.iter();
    let r = parts.fold(x, |r, &part| r.minus_product(turns, L::splat(part)));
    let square = r * r;
    let sine = r.plus_product(r * square, polynomial(square, L::Float::SINE));
    // Of −0 the sum is +0.
    let sine = sine.with_sign_of(r);
    let half = constant::<L>(0.5) * square;
    // What is lost of 1 − r²/2 is added again.
    let cosine = L::ONE - half;
    let lost = (L::ONE - cosine) - half;
    let rest = lost.plus_product(square * square, polynomial(square, L::Float::COSINE));
    let cosine = cosine + rest;
    // A quarter further, (sin, cos) is (cos, −sin); half a turn further, the opposite.
    let quarter = parity(turns);
    let half = parity((turns - quarter) * constant(0.5));
    let odd = L::ZERO.is_less(quarter);
    let two = constant::<L>(2.0);
    let sign = L::ONE - two * half;
    let (sine, cosine) = (
        L::select(odd, cosine, sine) * sign,
        L::select(odd, sine, cosine) * (sign - two * sign * quarter),
    );
    if L::all(near) {
        return (sine, cosine);
    }
    let (far_sine, far_cosine) = by_library(x);
    (
        L::select(near, sine, far_sine),
        L::select(near, cosine, far_cosine),
    )
}

#[cold]
#[inline(never)]
fn by_library<L: Lanes>(x: L) -> (L, L) {
    (x.map(|x| x.sin_cos().0), x.map(|x| x.sin_cos().1))
}
