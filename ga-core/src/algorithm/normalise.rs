//! The versor nearest to an even element: (X X̃)^(−1/2) X.

use super::parts::{
    Bivectors, Fourvectors, Parts, Versors, outer_square, sum_of_sizes, sum_of_squares, turned,
};
use super::study::Study;
use crate::ops::{self, Element};
use crate::{Computation, Field, Real, Scalar};

/// The part of X X̃ that is no number, against the number, that is taken for drift.
const DRIFT: f64 = 1e-6;

/// How bivectors and four-vectors fail to commute: only in five dimensions and if they are not
/// parts of one versor.
#[derive(Clone, Copy)]
pub struct Commutators<F, G> {
    /// (A V − V A)/2 of a bivector and a four-vector.
    pub planes: F,
    /// (V V′ − V′ V)/2 of two four-vectors.
    pub fourths: G,
}

/// (X X̃)^(−1/2) X of an even element in up to five dimensions: a unit versor; `None` where
/// X X̃ has no inverse square root, or where its scalar part is not positive.
///
/// X X̃ of a versor is a number but for rounding. With a negative one, rounding alone would
/// decide whether there is a root, and in which direction.
/// `commutators` are of the bivector and the four-vector part.
#[cfg_attr(not(all(feature = "inlined", not(debug_assertions))), inline)]
#[cfg_attr(all(feature = "inlined", not(debug_assertions)), inline(always))]
pub fn renormalise<T, X, A, Q, R>(
    element: X,
    commutators: Commutators<impl Fn(A, Q) -> Q, impl Fn(Q, Q) -> A>,
) -> Option<R>
where
    T: Real,
    X: Element<Number = T>,
    A: Bivectors<Number = T>,
    Q: Fourvectors<A, Number = T>,
    R: Versors<A, Q, Number = T>,
{
    let parts = Parts::<T, A, Q>::of(element);
    let norm = parts.norm_squared(&commutators);
    if !T::ZERO.all_le(norm.scalar) {
        return None;
    }
    parts.over_root(norm, &commutators).finite_sum()
}

/// An element whose X X̃ is a number, over its norm; `None` where that is no positive number.
#[cfg_attr(not(all(feature = "inlined", not(debug_assertions))), inline)]
#[cfg_attr(all(feature = "inlined", not(debug_assertions)), inline(always))]
pub fn over_norm<X>(element: X) -> Option<X>
where
    X: Element<Number: Real>
        + ops::NormSquared<Output = X::Number>
        + ops::Geometric<X::Number, Output = X>,
{
    let norm = element.norm_squared().sqrt();
    let exists = norm.is_invertible() && norm.is_finite();
    exists.then(|| element.geometric(X::Number::ONE / norm))
}

/// X X̃ as a number and a four-vector.
#[derive(Clone, Copy, PartialEq)]
struct NormSquared<T, Q> {
    scalar: T,
    fourth: Q,
}

impl<T: Real, Q: Element<Number = T>> NormSquared<T, Q> {
    /// How far it is from 1.
    #[inline(always)]
    fn deviation(&self) -> T {
        (self.scalar - T::ONE).abs() + sum_of_sizes(&self.fourth)
    }
}

impl<T, A, Q> Parts<T, A, Q>
where
    T: Real,
    A: Bivectors<Number = T>,
    Q: Fourvectors<A, Number = T>,
{
    /// X X̃ = x₀² − X₂² + X₄² + 2x₀X₄ + (X₂X₄ − X₄X₂).
    #[cfg_attr(not(all(feature = "inlined", not(debug_assertions))), inline)]
    #[cfg_attr(all(feature = "inlined", not(debug_assertions)), inline(always))]
    fn norm_squared<G>(
        &self,
        commutators: &Commutators<impl Fn(A, Q) -> Q, G>,
    ) -> NormSquared<T, Q> {
        let (x, plane, fourth) = (self.scalar, self.bivector, self.fourth);
        let scalar = x * x - plane.scalar_product(plane) + fourth.scalar_product(fourth);
        let outer: Q = outer_square(plane);
        let half = fourth.geometric(x) + (commutators.planes)(plane, fourth);
        let fourth = half + half - outer;
        NormSquared { scalar, fourth }
    }

    /// X over the square root of X X̃, from the left.
    #[cfg_attr(all(feature = "inlined", not(debug_assertions)), inline(always))]
    fn over_root(
        self,
        norm: NormSquared<T, Q>,
        commutators: &Commutators<impl Fn(A, Q) -> Q, impl Fn(Q, Q) -> A>,
    ) -> Self {
        let square = Study {
            scalar: norm.scalar,
            fourth: T::ONE,
            square: norm.fourth.scalar_product(norm.fourth),
        };
        let factor = square.sqrt().inverse();
        let (own, image) = (factor.scalar, factor.fourth);
        let turned = turned(norm.fourth, self.bivector);
        let turned = turned + (commutators.fourths)(norm.fourth, self.fourth);
        let beside =
            norm.fourth.geometric(self.scalar) - (commutators.planes)(self.bivector, norm.fourth);
        let product = norm.fourth.scalar_product(self.fourth);
        Parts {
            scalar: self.scalar * own + product * image,
            bivector: self.bivector.geometric(own) + turned.geometric(image),
            fourth: self.fourth.geometric(own) + beside.geometric(image),
        }
    }

    /// The unit versor in the direction of a versor, and its norm; `None` for what is no versor:
    /// where R R̃ is not a positive number.
    ///
    /// A versor whose R R̃ is 1 up to rounding is left as it is: of a large boost R R̃ is a small
    /// difference of large numbers, and says less about its norm than the promise to be unit.
    /// A part of R R̃ that is no number but less than a millionth of it is drift, and removed.
    #[cfg_attr(not(all(feature = "inlined", not(debug_assertions))), inline)]
    #[cfg_attr(all(feature = "inlined", not(debug_assertions)), inline(always))]
    pub(super) fn unit(
        self,
        commutators: &Commutators<impl Fn(A, Q) -> Q, impl Fn(Q, Q) -> A>,
    ) -> Option<(Self, T)> {
        match self.is_unit(commutators) {
            true => Some((self, T::ONE)),
            false => T::outlined(OverNorm(self, commutators)),
        }
    }

    /// Whether X X̃ is 1 up to rounding, with derivatives that are zero.
    #[inline(always)]
    pub(super) fn is_unit<G>(&self, commutators: &Commutators<impl Fn(A, Q) -> Q, G>) -> bool {
        let norm = self.norm_squared(commutators);
        let deviation = norm.deviation();
        if !deviation.all_le(rounding_of(T::ONE)) {
            let rounding = rounding_of(self.size());
            if !(deviation.all_le(rounding) && rounding.is_finite()) {
                return false;
            }
        }
        let mut constant = norm.scalar.at_value(T::ONE) == T::ONE;
        for i in 0..Q::BLADES.len() {
            constant &= norm.fourth.at(i).at_value(T::ZERO) == T::ZERO;
        }
        constant
    }

    /// The sum of the squares of the coefficients.
    #[inline(always)]
    pub(super) fn size(&self) -> T {
        let parts = sum_of_squares(&self.bivector) + sum_of_squares(&self.fourth);
        self.scalar * self.scalar + parts
    }

    /// The unit versor and its norm, where the norm is not 1, or not in all lanes.
    #[cfg_attr(all(feature = "inlined", not(debug_assertions)), inline(always))]
    pub(super) fn over_norm(
        self,
        commutators: &Commutators<impl Fn(A, Q) -> Q, impl Fn(Q, Q) -> A>,
    ) -> Option<(Self, T)> {
        let norm = self.norm_squared(commutators);
        let rounding = rounding_of(self.size());
        if !rounding.is_finite() {
            return None;
        }
        let deviation = norm.deviation();
        let one = norm.scalar.at_value(T::ONE);
        let exact = NormSquared {
            scalar: deviation.select_le(rounding, one, norm.scalar),
            fourth: Q::from_fn(|i| {
                let value = norm.fourth.at(i);
                deviation.select_le(rounding, value.at_value(T::ZERO), value)
            }),
        };
        let drift = norm.scalar * T::from_f64(DRIFT);
        let rest = sum_of_sizes(&norm.fourth);
        if !(rest.all_le(drift + rounding) && norm.scalar.is_invertible()) {
            return None;
        }
        let length = exact.scalar.sqrt();
        if !length.is_finite() {
            return None;
        }
        Some((self.over_root(exact, commutators), length))
    }
}

/// Takes a versor over its norm.
pub(super) struct OverNorm<'c, T, A, Q, F, G>(
    pub(super) Parts<T, A, Q>,
    pub(super) &'c Commutators<F, G>,
);

impl<T, A, Q, F, G> Computation for OverNorm<'_, T, A, Q, F, G>
where
    T: Real,
    A: Bivectors<Number = T>,
    Q: Fourvectors<A, Number = T>,
    F: Fn(A, Q) -> Q,
    G: Fn(Q, Q) -> A,
{
    type Output = Option<(Parts<T, A, Q>, T)>;

    #[cfg_attr(all(feature = "inlined", not(debug_assertions)), inline(always))]
    fn run(self) -> Self::Output {
        self.0.over_norm(self.1)
    }
}

/// How far X X̃ may be from 1 by rounding, for squares of coefficients that add up to `size`.
#[inline(always)]
pub(crate) fn rounding_of<T: Real>(size: T) -> T {
    size * T::EPSILON * T::from_integer(64)
}
