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
    margin: T,
    /// Not above zero near −1.
    pub near: T,
}

/// Not above zero near −1, for the scalar and the square of the bivector of a unit versor.
#[inline]
pub(super) fn nearness<T: Real>(scalar: T, square: T) -> T {
    let half = T::from_ratio(1, 2);
    let (short, opposed) = (square.abs() - half * half, scalar + half);
    (short - opposed).select_le(T::ZERO, opposed, short)
}

/// One of the two components of a versor: the cosine of its turn and minus the square of its
/// sine.
#[derive(Clone, Copy)]
pub(super) struct Turn<T> {
    pub cosine: T,
    pub square: T,
}

/// The values of g and f.
#[derive(Clone, Copy)]
pub(super) struct Values<N> {
    pub even: N,
    pub factor: N,
}

/// g + f A.
pub(super) struct Evaluated<T, A> {
    /// g.
    pub even: Study<T>,
    /// f A.
    pub bivector: A,
}

impl<T, A, Q> Separation<T, A, Q>
where
    T: Real,
    A: Bivectors<Number = T>,
    Q: Fourvectors<A, Number = T>,
{
    /// Looks at a unit versor.
    pub fn of(unit: Parts<T, A, Q>) -> Self {
        let Parts {
            scalar, bivector, ..
        } = unit;
        let half = T::from_ratio(1, 2);
        let square = bivector.scalar_product(bivector);
        let outer: Q = outer_square(bivector);
        // Near −1 the bivector knows V better than V itself: A∧A = 2⟨R⟩V.
        let near = nearness(scalar, square);
        let factor = half / scalar;
        let fourth =
            Q::from_fn(|i| near.select_le(T::ZERO, outer.at(i) * factor, unit.fourth.at(i)));
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
            near,
        }
    }

    /// Not above zero where 1 + c has one small and one larger real component.
    fn margin(above: Study<T>) -> T {
        let root = above
            .square
            .select_le(T::ZERO, T::ZERO, above.square.sqrt());
        let spread = above.fourth.abs() * root;
        let (low, high) = (above.scalar - spread, above.scalar + spread);
        let small = low - T::from_ratio(1, 4);
        let smaller = low + low - high;
        let larger = small.select_le(smaller, smaller, small);
        root.select_le(T::ZERO, T::ONE, larger)
    }

    /// Evaluates `g + f A` for functions g and f of the Study number c: by `series`, or where one
    /// turn is near π by `closed` on each of both turns.
    #[inline]
    pub fn evaluate(
        &self,
        series: impl FnOnce(Study<T>) -> Values<Study<T>>,
        closed: impl Fn(Turn<T>) -> Option<Values<T>>,
    ) -> Option<Evaluated<T, A>> {
        if T::ZERO.all_le(self.margin) {
            return Some(self.together(series(self.above)));
        }
        let root = self.cosine.square.sqrt();
        let components = self.components(root);
        if self.margin.all_le(T::ZERO) {
            let values = [closed(components[0].1)?, closed(components[1].1)?];
            return Some(self.apart(root, components, values));
        }
        // Some lanes are near the edge: both ways, and a harmless turn for the other lanes.
        let harmless = |turn: Turn<T>| Turn {
            cosine: self.margin.select_le(T::ZERO, turn.cosine, T::ONE),
            square: self.margin.select_le(T::ZERO, turn.square, T::ZERO),
        };
        let turns = components.map(|(_, turn)| harmless(turn));
        let values = [closed(turns[0])?, closed(turns[1])?];
        let apart = self.apart(root, components, values);
        let together = self.together(series(self.above));
        Some(Evaluated {
            even: apart.even.select_le(self.margin, T::ZERO, together.even),
            bivector: A::from_fn(|i| {
                let (apart, together) = (apart.bivector.at(i), together.bivector.at(i));
                self.margin.select_le(T::ZERO, apart, together)
            }),
        })
    }

    /// The components ½(1 ± V/|V|) A of the bivector, with their turns.
    fn components(&self, root: T) -> [(A, Turn<T>); 2] {
        let half = T::from_ratio(1, 2);
        let image = self.turned.geometric(half / root);
        [T::ONE, -T::ONE].map(|sign| {
            let component = self.bivector.geometric(half) + image.geometric(sign);
            let square = component.scalar_product(component);
            let turn = Turn {
                cosine: self.cosine.scalar + sign * root,
                square: square + square,
            };
            (component, turn)
        })
    }

    /// g + f A from values on Study numbers.
    fn together(&self, values: Values<Study<T>>) -> Evaluated<T, A> {
        let Values { even, factor } = values;
        Evaluated {
            even,
            bivector: self.bivector.geometric(factor.scalar) + self.turned.geometric(factor.fourth),
        }
    }

    /// g + f A from values on the two components.
    fn apart(
        &self,
        root: T,
        [(one, _), (other, _)]: [(A, Turn<T>); 2],
        [plus, minus]: [Values<T>; 2],
    ) -> Evaluated<T, A> {
        let half = T::from_ratio(1, 2);
        Evaluated {
            even: self.cosine.with(
                (plus.even + minus.even) * half,
                (plus.even - minus.even) * half / root,
            ),
            bivector: one.geometric(plus.factor) + other.geometric(minus.factor),
        }
    }
}
