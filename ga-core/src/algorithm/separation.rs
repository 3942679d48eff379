//! Where a unit versor is near the edge of its logarithm, and what is known about it there.
//!
//! A versor e^{θ₁B₁ + θ₂B₂} has two turns θ₁ ± θ₂. Where one comes near π, the scalar and the
//! four-vector part say nothing about the distance from π, but the bivector part does: its
//! component of that turn is as long as the sine.

use core::marker::PhantomData;

use super::parts::{Bivectors, Fourvectors, Parts, outer_square, turned};
use super::study::Study;
use crate::{Computation, Real};

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
#[inline(always)]
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

impl<T: Real> Turn<T> {
    /// The turn in lanes that are near the edge, none in the others.
    #[inline(always)]
    fn harmless_above(self, margin: T) -> Self {
        Turn {
            cosine: margin.select_le(T::ZERO, self.cosine, T::ONE),
            square: margin.select_le(T::ZERO, self.square, T::ZERO),
        }
    }
}

/// The values of g and f.
#[derive(Clone, Copy)]
pub(super) struct Values<N> {
    pub even: N,
    pub factor: N,
}

/// Functions g and f of a turn.
pub(super) trait TurnFunctions<T> {
    /// Their values for both turns at a time, given 1 + c.
    fn together(above: Study<T>) -> Values<Study<T>>;
    /// Their values for one turn.
    fn apart(turn: Turn<T>) -> Option<Values<T>>;
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
    #[cfg_attr(all(feature = "inlined", not(debug_assertions)), inline(always))]
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
    #[cfg_attr(all(feature = "inlined", not(debug_assertions)), inline(always))]
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

    /// Evaluates `g + f A` for functions g and f of the Study number c: together, or where one turn
    /// is near π for each of both turns.
    #[cfg_attr(not(all(feature = "inlined", not(debug_assertions))), inline)]
    #[cfg_attr(all(feature = "inlined", not(debug_assertions)), inline(always))]
    pub fn evaluate<F: TurnFunctions<T>>(self) -> Option<Evaluated<T, A>> {
        if T::ZERO.all_le(self.margin) {
            return Some(self.together(F::together(self.above)));
        }
        T::outlined(EvaluateNearTheEdge {
            separation: self,
            functions: PhantomData::<F>,
        })
    }

    /// The components ½(1 ± V/|V|) A of the bivector, with their turns.
    #[cfg_attr(all(feature = "inlined", not(debug_assertions)), inline(always))]
    fn components(&self, root: T) -> [(A, Turn<T>); 2] {
        let half = T::from_ratio(1, 2);
        let image = self.turned.geometric(half / root);
        let own = self.bivector.geometric(half);
        let (one, other) = (own + image, own - image);
        let squares = [one.scalar_product(one), other.scalar_product(other)];
        let turns = [
            Turn {
                cosine: self.cosine.scalar + root,
                square: squares[0] + squares[0],
            },
            Turn {
                cosine: self.cosine.scalar - root,
                square: squares[1] + squares[1],
            },
        ];
        [(one, turns[0]), (other, turns[1])]
    }

    /// g + f A from values on Study numbers.
    #[cfg_attr(all(feature = "inlined", not(debug_assertions)), inline(always))]
    fn together(&self, values: Values<Study<T>>) -> Evaluated<T, A> {
        let Values { even, factor } = values;
        Evaluated {
            even,
            bivector: self.bivector.geometric(factor.scalar) + self.turned.geometric(factor.fourth),
        }
    }

    /// g + f A from values on the two components.
    #[cfg_attr(all(feature = "inlined", not(debug_assertions)), inline(always))]
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

/// Evaluates functions where one turn is near π, in some lanes or in all.
struct EvaluateNearTheEdge<T, A, Q, F> {
    separation: Separation<T, A, Q>,
    functions: PhantomData<F>,
}

impl<T, A, Q, F> Computation for EvaluateNearTheEdge<T, A, Q, F>
where
    T: Real,
    A: Bivectors<Number = T>,
    Q: Fourvectors<A, Number = T>,
    F: TurnFunctions<T>,
{
    type Output = Option<Evaluated<T, A>>;

    #[cfg_attr(all(feature = "inlined", not(debug_assertions)), inline(always))]
    fn run(self) -> Self::Output {
        let separation = &self.separation;
        let margin = separation.margin;
        let root = separation.cosine.square.sqrt();
        let components = separation.components(root);
        if margin.all_le(T::ZERO) {
            let values = [F::apart(components[0].1)?, F::apart(components[1].1)?];
            return Some(separation.apart(root, components, values));
        }
        // Some lanes are near the edge: both ways, and a harmless turn for the other lanes.
        let turns = [
            components[0].1.harmless_above(margin),
            components[1].1.harmless_above(margin),
        ];
        let values = [F::apart(turns[0])?, F::apart(turns[1])?];
        let apart = separation.apart(root, components, values);
        let together = separation.together(F::together(separation.above));
        Some(Evaluated {
            even: apart.even.select_le(margin, T::ZERO, together.even),
            bivector: A::from_fn(|i| {
                let (apart, together) = (apart.bivector.at(i), together.bivector.at(i));
                margin.select_le(T::ZERO, apart, together)
            }),
        })
    }
}
