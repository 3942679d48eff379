//! The versor nearest to an even element: X (X X̃)^(−1/2).

use super::parts::{Bivectors, Fourvectors, Parts, Versors, outer_square, sum_of, turned};
use super::study::Study;
use crate::Real;

/// How many roundings of its terms X X̃ may be away from 1 for X to be taken as a unit versor.
const ROUNDINGS: i64 = 64;
/// The part of X X̃ that is no number, against the number, that is taken for drift.
const DRIFT: f64 = 1e-6;

/// X (X X̃)^(−1/2) of an even element in up to five dimensions: a unit versor; `None` where
/// X X̃ has no inverse square root.
///
/// `commutator` gives X₂X₄ − X₄X₂ of the bivector and the four-vector part.
#[inline]
pub fn renormalise<T, X, A, Q, R>(element: X, commutator: impl Fn(A, Q) -> Q) -> Option<R>
where
    T: Real,
    X: crate::ops::Element<Number = T>,
    A: Bivectors<Q, Number = T>,
    Q: Fourvectors<A, Number = T>,
    R: Versors<A, Q, Number = T>,
{
    let parts = Parts::<T, A, Q>::of(element);
    let norm = parts.norm_squared(commutator);
    parts.over_root(norm).finite_sum()
}

/// X X̃ as a number and a four-vector.
#[derive(Clone, Copy)]
struct NormSquared<T, Q> {
    scalar: T,
    fourth: Q,
}

impl<T, A, Q> Parts<T, A, Q>
where
    T: Real,
    A: Bivectors<Q, Number = T>,
    Q: Fourvectors<A, Number = T>,
{
    /// X X̃ = x₀² − X₂² + X₄² + 2x₀X₄ + (X₂X₄ − X₄X₂).
    fn norm_squared(&self, commutator: impl Fn(A, Q) -> Q) -> NormSquared<T, Q> {
        let (x, plane, fourth) = (self.scalar, self.bivector, self.fourth);
        let scalar = x * x - plane.scalar_product(plane) + fourth.scalar_product(fourth);
        let outer: Q = outer_square(plane);
        let fourth = fourth.geometric(x + x) - outer + commutator(plane, fourth);
        NormSquared { scalar, fourth }
    }

    /// X over the square root of X X̃.
    fn over_root(self, norm: NormSquared<T, Q>) -> Self {
        let square = Study {
            scalar: norm.scalar,
            fourth: T::ONE,
            square: norm.fourth.scalar_product(norm.fourth),
        };
        let factor = square.sqrt().inverse();
        let turned = turned(norm.fourth, self.bivector);
        let product = norm.fourth.scalar_product(self.fourth);
        Parts {
            scalar: self.scalar * factor.scalar + product * factor.fourth,
            bivector: self.bivector.geometric(factor.scalar) + turned.geometric(factor.fourth),
            fourth: self.fourth.geometric(factor.scalar)
                + norm.fourth.geometric(self.scalar * factor.fourth),
        }
    }

    /// The unit versor in the direction of a versor, and its norm; `None` for what is no versor:
    /// where R R̃ is not a positive number.
    ///
    /// A versor whose R R̃ is 1 up to rounding is left as it is: of a large boost R R̃ is a small
    /// difference of large numbers, and says less about its norm than the promise to be unit.
    /// A part of R R̃ that is no number but less than a millionth of it is drift, and removed.
    #[inline]
    pub(super) fn unit(self, commutator: impl Fn(A, Q) -> Q) -> Option<(Self, T)> {
        let norm = self.norm_squared(commutator);
        let squares = |x: T| x * x;
        let size =
            squares(self.scalar) + sum_of(&self.bivector, squares) + sum_of(&self.fourth, squares);
        let rounding = size * T::EPSILON * T::from_integer(ROUNDINGS);
        let rest = sum_of(&norm.fourth, T::abs);
        let deviation = (norm.scalar - T::ONE).abs() + rest;
        if deviation.all_le(rounding) {
            return Some((self, T::ONE));
        }
        let drift = norm.scalar * T::from_f64(DRIFT);
        if !(rest.all_le(drift + rounding) && norm.scalar.is_invertible()) {
            return None;
        }
        let unit = self.over_root(norm);
        let length = deviation.select_le(rounding, T::ONE, norm.scalar.sqrt());
        length.is_finite().then(|| {
            let parts = Parts {
                scalar: deviation.select_le(rounding, self.scalar, unit.scalar),
                bivector: A::from_fn(|i| {
                    deviation.select_le(rounding, self.bivector.at(i), unit.bivector.at(i))
                }),
                fourth: Q::from_fn(|i| {
                    deviation.select_le(rounding, self.fourth.at(i), unit.fourth.at(i))
                }),
            };
            (parts, length)
        })
    }
}
