//! Where a unit versor is near the edge of its logarithm, and what is known about it there.
//!
//! A versor e^{θ₁B₁ + θ₂B₂} has two turns θ₁ ± θ₂. Where one comes near π, the scalar and the
//! four-vector part say nothing about the distance from π, but the bivector part does: its
//! component of that turn is as long as the sine.

use super::parts::{Bivectors, Fourvectors, Parts, outer_square, turned};
use super::study::Study;
use crate::Real;

/// A unit versor c + A, where c = ⟨R⟩ + V is a Study number.
pub(super) struct Separation<T, A, Q> {
    /// The Study number ⟨R⟩ + V.
    pub cosine: Study<T>,
    /// The Study number 1 + c, without cancellation where c is near −1.
    pub above: Study<T>,
    /// A.
    pub bivector: A,
    /// V.
    pub fourth: Q,
    /// V A.
    pub turned: A,
    /// Not above zero where one turn is near π and the other is not.
    pub margin: T,
}

/// One of the two components of a versor: the cosine of its turn and minus the square of its
/// sine.
#[derive(Clone, Copy)]
pub(super) struct Turn<T> {
    pub cosine: T,
    pub square: T,
}

impl<T, A, Q> Separation<T, A, Q>
where
    T: Real,
    A: Bivectors<Q, Number = T>,
    Q: Fourvectors<A, Number = T>,
{
    /// Looks at a unit versor.
    #[inline]
    pub fn of(unit: Parts<T, A, Q>) -> Self {
        let Parts {
            scalar, bivector, ..
        } = unit;
        let half = T::from_ratio(1, 2);
        let square = bivector.scalar_product(bivector);
        let outer: Q = outer_square(bivector);
        // Near −1 the bivector knows V better than V itself: A∧A = 2⟨R⟩V.
        let near = square.abs() + scalar * half;
        let factor = half / scalar;
        let fourth = Q::from_fn(|i| {
            near.select_le(T::ZERO, outer.at(i) * factor, unit.fourth.at(i))
        });
        let cosine = Study {
            scalar,
            fourth: T::ONE,
            square: fourth.scalar_product(fourth),
        };
        // 1 + c = −A²/(1 − c).
        let opposite = cosine.with(T::ONE - scalar, -T::ONE).inverse();
        let quotient = cosine.with(-square, -(scalar + scalar)) * opposite;
        let above = quotient.select_le(near, T::ZERO, cosine.plus(T::ONE));
        Separation {
            cosine,
            above,
            bivector,
            fourth,
            turned: turned(fourth, bivector),
            margin: Self::margin(above),
        }
    }

    /// Not above zero where 1 + c has one small and one larger real component.
    fn margin(above: Study<T>) -> T {
        let root = above.square.select_le(T::ZERO, T::ZERO, above.square.sqrt());
        let spread = above.fourth.abs() * root;
        let (low, high) = (above.scalar - spread, above.scalar + spread);
        let small = low - T::from_ratio(1, 4);
        let smaller = low + low - high;
        let larger = small.select_le(smaller, smaller, small);
        root.select_le(T::ZERO, T::ONE, larger)
    }

    /// Evaluates a function of the versor: by `series` on Study numbers, or where one turn is near
    /// π by `closed` on each of both turns.
    #[inline]
    pub fn evaluate<const N: usize>(
        &self,
        series: impl FnOnce(Study<T>) -> [Study<T>; N],
        closed: impl Fn(Turn<T>) -> Option<[T; N]>,
    ) -> Option<[Study<T>; N]> {
        if T::ZERO.all_le(self.margin) {
            return Some(series(self.above));
        }
        let root = self.cosine.square.sqrt();
        let [plus, minus] = self.turns(root);
        if self.margin.all_le(T::ZERO) {
            return Some(joined(self.cosine, root, closed(plus)?, closed(minus)?));
        }
        // Some lanes are near the edge: both ways, and a harmless turn for the other lanes.
        let harmless = |turn: Turn<T>| Turn {
            cosine: self.margin.select_le(T::ZERO, turn.cosine, T::ONE),
            square: self.margin.select_le(T::ZERO, turn.square, T::ZERO),
        };
        let (plus, minus) = (closed(harmless(plus))?, closed(harmless(minus))?);
        let apart = joined(self.cosine, root, plus, minus);
        let together = series(self.above);
        Some(core::array::from_fn(|i| {
            apart[i].select_le(self.margin, T::ZERO, together[i])
        }))
    }

    /// The components ½(1 ± V/|V|) of the versor.
    fn turns(&self, root: T) -> [Turn<T>; 2] {
        let unit = self.turned.geometric(T::ONE / root);
        let half = T::from_ratio(1, 2);
        [T::ONE, -T::ONE].map(|sign| {
            let component = self.bivector + unit.geometric(sign);
            Turn {
                cosine: self.cosine.scalar + sign * root,
                square: component.scalar_product(component) * half,
            }
        })
    }
}

/// The Study numbers with these values on the two components.
fn joined<T: Real, const N: usize>(
    cosine: Study<T>,
    root: T,
    plus: [T; N],
    minus: [T; N],
) -> [Study<T>; N] {
    let half = T::from_ratio(1, 2);
    core::array::from_fn(|i| {
        cosine.with(
            (plus[i] + minus[i]) * half,
            (plus[i] - minus[i]) * half / root,
        )
    })
}
