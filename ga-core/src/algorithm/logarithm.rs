//! Principal logarithms of even versors in up to five dimensions.

use super::exponential::exponential_parts;
use super::normalise::Commutators;
use super::parts::{Bivectors, Fourvectors, Parts, finite, outer_square, turned};
use super::separation::{Separation, Values};
use super::study::Study;
use crate::ops::Element;
use crate::{Dual, Real};

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
    let (unit, _) = Parts::<T, A, Q>::of(versor).unit(&commutators)?;
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
/// the same on dual numbers, where the factor has a closed form.
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
    let (unit, _) = Parts::<T, A, Q>::of(versor).unit(&commutators)?;
    let Separation {
        cosine,
        bivector,
        fourth,
        turned: image,
        near,
        ..
    } = Separation::of(unit);
    let square = bivector.scalar_product(bivector);
    let sine = Dual::new(square, cosine.scalar + cosine.scalar);
    let factor = Dual::new(cosine.scalar, T::ONE).log_factor(sine)?;
    let logarithm = bivector.geometric(factor.re) + image.geometric(factor.eps);
    if T::ZERO.all_le(near) {
        return finite(logarithm);
    }
    // Near −1 the two terms are large and nearly cancel in the part that B∧B = 2f V knows.
    let square = logarithm.scalar_product(logarithm);
    let missing = fourth.geometric(factor.re + factor.re) - outer_square(logarithm);
    let share = near.select_le(T::ZERO, T::from_ratio(1, 2) / square, T::ZERO);
    finite(logarithm + turned(missing, logarithm).geometric(share))
}
