//! The angle of a point: by eighths of a turn from the arc tangent of |t| ≤ √2 − 1.

use super::polynomial::polynomial;
use super::{constant, is_not_a_number};
use crate::scalar::lanes::Lanes;
use crate::scalar::precision::Precision;

/// The angle of the point (x, y) in radians, in [−π, π]: signed zeros and infinities as of
/// `f64::atan2`.
#[cfg_attr(not(all(feature = "inlined", not(debug_assertions))), inline)]
#[cfg_attr(all(feature = "inlined", not(debug_assertions)), inline(always))]
pub fn atan2<L: Lanes>(y: L, x: L) -> L {
    let (width, height) = (x.magnitude(), y.magnitude());
    let steep = width.is_less(height);
    let large = L::select(steep, height, width);
    let small = L::select(steep, width, height);
    // Half a turn of the point, whose coordinates could overflow in a sum or be no quotient.
    let quarter = constant::<L>(0.25);
    let huge = L::splat(L::Float::LARGEST);
    let infinite = huge.is_less(large);
    let exact = |x: L| {
        let finite = L::select(huge.is_less(x), L::ONE, L::ZERO);
        L::select(infinite, finite, x)
    };
    let (large, small) = (exact(large), exact(small));
    let scaled = (huge * quarter).is_less(large);
    let large = L::select(scaled, large * quarter, large);
    let small = L::select(scaled, small * quarter, small);
    let large = L::select(large.is_at_most(L::ZERO), L::ONE, large);
    let eighth = constant::<L>(core::f64::consts::SQRT_2 - 1.0);
    let turned = (large * eighth).is_less(small);
    let numerator = L::select(turned, small - large, small);
    let denominator = L::select(turned, small + large, large);
    let t = numerator / denominator;
    let square = t * t;
    let arc = t.plus_product(t * square, polynomial(square, L::Float::ARCTANGENT));
    // The angle is a number of eighths of a turn and the arc, which both reflections reverse.
    let eighths = L::select(turned, L::ONE, L::ZERO);
    let eighths = L::select(steep, constant::<L>(2.0) - eighths, eighths);
    let arc = L::select(steep, -arc, arc);
    let left = L::ONE.with_sign_of(x).is_less(L::ZERO);
    let eighths = L::select(left, constant::<L>(4.0) - eighths, eighths);
    let arc = L::select(left, -arc, arc);
    let [high, low] = L::Float::QUARTER_PI;
    let rest = arc.plus_product(eighths, L::splat(low));
    let angle = rest.plus_product(eighths, L::splat(high)).with_sign_of(y);
    let neither = is_not_a_number(x) | is_not_a_number(y);
    L::select(neither, x + y, angle)
}
