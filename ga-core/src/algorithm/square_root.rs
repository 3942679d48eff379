//! Principal square roots of even versors in up to five dimensions.

use super::normalise::Commutators;
use super::parts::{Bivectors, Fourvectors, Parts, Versors};
use super::separation::{Separation, Turn, TurnFunctions, Values};
use super::study::Study;
use crate::Real;
use crate::ops::Element;

/// The principal square root h + A/(2h) of a versor `R = c + A`, with the Study number
/// h = √((1 + c)/2): the normalised 1 + R for a unit versor (2.37, 2.38, 5.11).
///
/// Its square is R, norm included. `None` where no real logarithm exists or it is not unique,
/// and for what is no versor. `commutators` are of
/// the parts of R.
#[cfg_attr(not(all(feature = "inlined", not(debug_assertions))), inline)]
#[cfg_attr(all(feature = "inlined", not(debug_assertions)), inline(always))]
pub fn square_root<T, X, A, Q, R>(
    versor: X,
    commutators: Commutators<impl Fn(A, Q) -> Q, impl Fn(Q, Q) -> A>,
) -> Option<R>
where
    T: Real,
    X: Element<Number = T>,
    A: Bivectors<Number = T>,
    Q: Fourvectors<A, Number = T>,
    R: Versors<A, Q, Number = T>,
{
    let (unit, norm) = Parts::<T, A, Q>::of(versor).unit(&commutators)?;
    let separation = Separation::of(unit);
    let fourth = separation.fourth;
    let root = separation.evaluate::<HalfTurn>()?;
    let root = Parts {
        scalar: root.even.scalar,
        bivector: root.bivector,
        fourth: fourth.geometric(root.even.fourth),
    };
    if !unit.is_plain() {
        unit.is_near(root.squared()).then_some(())?;
    }
    let length = norm.sqrt();
    Parts {
        scalar: root.scalar * length,
        bivector: root.bivector.geometric(length),
        fourth: root.fourth.geometric(length),
    }
    .finite_sum()
}

/// The functions h and 1/(2h).
struct HalfTurn;

impl<T: Real> TurnFunctions<T> for HalfTurn {
    #[cfg_attr(all(feature = "inlined", not(debug_assertions)), inline(always))]
    fn together(above: Study<T>) -> Values<Study<T>> {
        let half = T::from_ratio(1, 2);
        let cosine = above.scaled(half).sqrt();
        Values {
            even: cosine,
            factor: cosine.inverse().scaled(half),
        }
    }

    #[cfg_attr(all(feature = "inlined", not(debug_assertions)), inline(always))]
    fn apart(turn: Turn<T>) -> Option<Values<T>> {
        let half = T::from_ratio(1, 2);
        // 1 + c cancels for negative c; (1 + c)(1 − c) = −A² does not.
        let quotient = -turn.square / (T::ONE - turn.cosine);
        let above = turn
            .cosine
            .select_le(T::ZERO, quotient, turn.cosine + T::ONE);
        let cosine = (above * half).sqrt();
        Some(Values {
            even: cosine,
            factor: half / cosine,
        })
    }
}
