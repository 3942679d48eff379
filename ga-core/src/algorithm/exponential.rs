//! Exponentials of bivectors whose outer square W has a number as its square, as all have in up
//! to five dimensions.

use super::parts::{Bivectors, Fourvectors, Parts, Versors, combined, outer_square, turned};
use super::study::Study;
use crate::Real;

/// The exponential `C(a + W) + S(a + W) B` of a bivector with `B² = a + W` (2.62 for Study
/// numbers).
///
/// Exact to the rounding of the bivector, whatever its planes: null, nearly null, isoclinic. Not
/// finite where the fourth power of a coefficient overflows.
#[cfg_attr(not(all(feature = "inlined", not(debug_assertions))), inline)]
#[cfg_attr(all(feature = "inlined", not(debug_assertions)), inline(always))]
pub fn bivector_exponential<T, A, Q, R>(bivector: A) -> R
where
    T: Real,
    A: Bivectors<Number = T>,
    Q: Fourvectors<A, Number = T>,
    R: Versors<A, Q, Number = T>,
{
    exponential_parts::<T, A, Q>(bivector).sum()
}

/// The exponential of a bivector, by grades.
#[cfg_attr(not(all(feature = "inlined", not(debug_assertions))), inline)]
#[cfg_attr(all(feature = "inlined", not(debug_assertions)), inline(always))]
pub(super) fn exponential_parts<T, A, Q>(bivector: A) -> Parts<T, A, Q>
where
    T: Real,
    A: Bivectors<Number = T>,
    Q: Fourvectors<A, Number = T>,
{
    let outer: Q = outer_square(bivector);
    let (square, outer_square) = (
        bivector.scalar_product(bivector),
        outer.scalar_product(outer),
    );
    let (cosh, sinhc) = Study::cosh_sinhc(square, outer_square);
    assembled(
        bivector,
        outer,
        [cosh.scalar, cosh.fourth],
        [sinhc.scalar, sinhc.fourth],
    )
}

/// `c + c′ W + (s + s′ W) B`.
#[inline(always)]
fn assembled<T, A, Q>(bivector: A, outer: Q, cosh: [T; 2], sinhc: [T; 2]) -> Parts<T, A, Q>
where
    T: Real,
    A: Bivectors<Number = T>,
    Q: Fourvectors<A, Number = T>,
{
    let turned = turned(outer, bivector);
    Parts {
        scalar: cosh[0],
        bivector: combined(bivector, sinhc[0], turned, sinhc[1]),
        fourth: outer.geometric(cosh[1]),
    }
}
