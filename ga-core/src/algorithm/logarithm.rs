//! Principal logarithms of even versors in up to five dimensions.

use super::exponential::exponential_parts;
use super::normalise::Commutators;
use super::parts::{Bivectors, Fourvectors, Parts, combined, finite, outer_square, turned};
use super::separation::{Separation, Values, nearness};
use super::study::Study;
use crate::Real;
use crate::ops::Element;

/// The principal logarithm of a versor over its norm: the bivector B = f(c) A with
/// `R = c + A`, c = ⟨R⟩ + ⟨R⟩₄ a Study number and f(cosh z) = z / sinh z.
///
/// Its turns are |θ₁| + |θ₂| ≤ π. `None` where no real logarithm exists, where it is not unique
/// (R = −1), and for what is no versor. `commutators` are of
/// the parts of R.
#[inline]
pub fn logarithm<T, X, A, Q>(
    versor: X,
    commutators: Commutators<impl Fn(A, Q) -> Q, impl Fn(Q, Q) -> A>,
) -> Option<A>
where
    T: Real,
    X: Element<Number = T>,
    A: Bivectors<Number = T>,
    Q: Fourvectors<A, Number = T>,
{
    let parts = Parts::<T, A, Q>::of(versor);
    match parts.is_unit(&commutators) {
        true => of_unit_parts(parts),
        false => of_unit_parts(parts.over_norm(&commutators)?.0),
    }
}

/// The logarithm of a versor that is promised to be a unit one.
#[inline]
pub fn logarithm_of_unit<T, X, A, Q>(versor: X) -> Option<A>
where
    T: Real,
    X: Element<Number = T>,
    A: Bivectors<Number = T>,
    Q: Fourvectors<A, Number = T>,
{
    of_unit_parts(Parts::<T, A, Q>::of(versor))
}

fn of_unit_parts<T, A, Q>(unit: Parts<T, A, Q>) -> Option<A>
where
    T: Real,
    A: Bivectors<Number = T>,
    Q: Fourvectors<A, Number = T>,
{
    let separation = Separation::of(unit);
    let half = T::from_ratio(1, 2);
    let logarithm = separation.evaluate(
        |above| {
            let factor = Study::log_factor(above.scaled(half).sqrt());
            Values {
                even: factor,
                factor,
            }
        },
        |turn| {
            let factor = turn.cosine.log_factor(turn.square)?;
            Some(Values {
                even: factor,
                factor,
            })
        },
    )?;
    let back = || exponential_parts(logarithm.bivector);
    unit.is_led_back_to(back).then_some(())?;
    finite(logarithm.bivector)
}

/// The logarithm of a versor whose four-vector part squares to zero, as that of a motor does:
/// there f(c + V) = f(c) + f′(c) V.
#[inline]
pub fn motor_logarithm<T, X, A, Q>(
    versor: X,
    commutators: Commutators<impl Fn(A, Q) -> Q, impl Fn(Q, Q) -> A>,
) -> Option<A>
where
    T: Real,
    X: Element<Number = T>,
    A: Bivectors<Number = T>,
    Q: Fourvectors<A, Number = T>,
{
    let parts = Parts::<T, A, Q>::of(versor);
    match parts.is_unit(&commutators) {
        true => motor_of_unit_parts(parts),
        // Apart, so that a unit versor stays in registers.
        false => motor_over_norm(parts, &commutators),
    }
}

/// The logarithm of a versor that is promised to be a unit one, and whose four-vector part
/// squares to zero.
#[inline]
pub fn motor_logarithm_of_unit<T, X, A, Q>(versor: X) -> Option<A>
where
    T: Real,
    X: Element<Number = T>,
    A: Bivectors<Number = T>,
    Q: Fourvectors<A, Number = T>,
{
    motor_of_unit_parts(Parts::<T, A, Q>::of(versor))
}

#[inline(never)]
fn motor_over_norm<T, A, Q>(
    parts: Parts<T, A, Q>,
    commutators: &Commutators<impl Fn(A, Q) -> Q, impl Fn(Q, Q) -> A>,
) -> Option<A>
where
    T: Real,
    A: Bivectors<Number = T>,
    Q: Fourvectors<A, Number = T>,
{
    motor_of_unit_parts(parts.over_norm(commutators)?.0)
}

/// f(c + V) A = f A + f′ V A.
#[inline(always)]
fn motor_of_unit_parts<T, A, Q>(unit: Parts<T, A, Q>) -> Option<A>
where
    T: Real,
    A: Bivectors<Number = T>,
    Q: Fourvectors<A, Number = T>,
{
    let square = unit.bivector.scalar_product(unit.bivector);
    let far = T::from_ratio(-1, 2).all_le(unit.scalar);
    if !(far || T::ZERO.all_le(nearness(unit.scalar, square))) {
        return motor_near_the_edge(unit);
    }
    let (factor, slope) = unit.scalar.log_factor_slope(square)?;
    let turned = turned(unit.fourth, unit.bivector);
    finite(combined(unit.bivector, factor, turned, slope))
}

/// The same where lanes may be near −1.
#[inline(never)]
fn motor_near_the_edge<T, A, Q>(unit: Parts<T, A, Q>) -> Option<A>
where
    T: Real,
    A: Bivectors<Number = T>,
    Q: Fourvectors<A, Number = T>,
{
    let Separation {
        cosine,
        bivector,
        fourth,
        turned: image,
        near,
        ..
    } = Separation::of(unit);
    let (factor, slope) = cosine
        .scalar
        .log_factor_slope(bivector.scalar_product(bivector))?;
    let logarithm = combined(bivector, factor, image, slope);
    // The two terms are large and nearly cancel in the part that B∧B = 2f V knows.
    let square = logarithm.scalar_product(logarithm);
    let missing = fourth.geometric(factor + factor) - outer_square(logarithm);
    let share = near.select_le(T::ZERO, T::from_ratio(1, 2) / square, T::ZERO);
    finite(combined(
        logarithm,
        T::ONE,
        turned(missing, logarithm),
        share,
    ))
}
