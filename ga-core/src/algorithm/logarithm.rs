//! Principal logarithms of even versors in up to five dimensions.

use super::parts::{Bivectors, Fourvectors, Parts, finite};
use super::separation::Separation;
use super::study::Study;
use crate::ops::Element;
use crate::{Dual, Real};

/// The principal logarithm of a versor over its norm: the bivector B = f(c) A with
/// `R = c + A`, c = ⟨R⟩ + ⟨R⟩₄ a Study number and f(cosh z) = z / sinh z.
///
/// Its turns are |θ₁| + |θ₂| ≤ π. `None` where no real logarithm exists, where it is not unique
/// (R = −1), and for what is no versor. `commutator` gives R₂R₄ − R₄R₂.
#[inline]
pub fn logarithm<T, X, A, Q>(versor: X, commutator: impl Fn(A, Q) -> Q) -> Option<A>
where
    T: Real,
    X: Element<Number = T>,
    A: Bivectors<Q, Number = T>,
    Q: Fourvectors<A, Number = T>,
{
    let (unit, _) = Parts::<T, A, Q>::of(versor).unit(commutator)?;
    let separation = Separation::of(unit);
    let half = T::from_ratio(1, 2);
    let [factor] = separation.evaluate(
        |above| [Study::log_factor(above.scaled(half).sqrt())],
        |turn| turn.cosine.log_factor(turn.square).map(|factor| [factor]),
    )?;
    finite(
        separation.bivector.geometric(factor.scalar)
            + separation.turned.geometric(factor.fourth),
    )
}

/// The logarithm of a versor whose four-vector part squares to zero, as that of a motor does:
/// the same on dual numbers, where the factor has a closed form.
#[inline]
pub fn motor_logarithm<T, X, A, Q>(versor: X, commutator: impl Fn(A, Q) -> Q) -> Option<A>
where
    T: Real,
    X: Element<Number = T>,
    A: Bivectors<Q, Number = T>,
    Q: Fourvectors<A, Number = T>,
{
    let (unit, _) = Parts::<T, A, Q>::of(versor).unit(commutator)?;
    let Separation {
        cosine,
        bivector,
        turned,
        ..
    } = Separation::of(unit);
    let square = bivector.scalar_product(bivector);
    let sine = Dual::new(square, cosine.scalar + cosine.scalar);
    let factor = Dual::new(cosine.scalar, T::ONE).log_factor(sine)?;
    finite(bivector.geometric(factor.re) + turned.geometric(factor.eps))
}
