//! The split of a bivector into two commuting blades.

use super::parts::{Bivectors, Fourvectors, finite, outer_square, turned};
use crate::Real;

/// How many roundings the squares of two blades are apart for the blades to be told apart.
const ROUNDINGS: i64 = 1024;

/// What a bivector consists of, in the order of the squares of the blades.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Split<B> {
    /// The one pair of commuting blades whose sum it is, the one of larger square first. A
    /// bivector that is a blade itself has zero as the other one.
    Blades([B; 2]),
    /// Both blades have the same square up to a thousand roundings, as those of an isoclinic
    /// rotation: there is a circle of such pairs or more, and none is distinguished.
    Isoclinic,
    /// There are no real ones; only where at least two basis vectors have positive and two have
    /// negative squares.
    Complex,
    /// A coefficient is not finite or so large that its fourth power is not.
    NotFinite,
}

impl<B> Split<B> {
    /// The two blades, where they are unique.
    pub fn blades(self) -> Option<[B; 2]> {
        match self {
            Split::Blades(blades) => Some(blades),
            Split::Isoclinic | Split::Complex | Split::NotFinite => None,
        }
    }
}

/// The blades B₁ = (2x B − W B)/(2(x − y)) and B₂ = (W B − 2y B)/(2(x − y)) of B = B₁ + B₂ with
/// B² = a + W, where x, y = (a ± √(a² − W²))/2 are their squares (5.5, 5.12).
pub fn split<T, A, Q>(bivector: A) -> Split<A>
where
    T: Real,
    A: Bivectors<Number = T>,
    Q: Fourvectors<A, Number = T>,
{
    let outer: Q = outer_square(bivector);
    let square = bivector.scalar_product(bivector);
    let product = outer.scalar_product(outer);
    let zero = bivector.geometric(T::ZERO);
    if (0..Q::BLADES.len()).all(|i| outer.at(i) == T::ZERO) {
        let negative = square.all_le(T::ZERO) && square != T::ZERO;
        let blades = if negative {
            [zero, bivector]
        } else {
            [bivector, zero]
        };
        return match finite(bivector) {
            Some(_) => Split::Blades(blades),
            None => Split::NotFinite,
        };
    }
    let turned: A = turned(outer, bivector);
    let (doubled, apart) = (product + product, square * square - product);
    let radicand = if doubled.all_le(square * square) {
        apart
    } else {
        // (a + |W|)(a − |W|), of which one cancels; the squares of the components do not.
        let image = turned.geometric(T::ONE / product.sqrt());
        let (plus, minus) = (bivector + image, bivector - image);
        let squares = plus.scalar_product(plus) * minus.scalar_product(minus);
        squares * T::from_ratio(1, 4)
    };
    if !radicand.is_finite() {
        return Split::NotFinite;
    }
    let rounding = square * T::EPSILON * T::from_integer(ROUNDINGS);
    if radicand.abs().all_le(rounding * rounding) {
        return Split::Isoclinic;
    }
    if radicand.all_le(T::ZERO) {
        return Split::Complex;
    }
    let root = radicand.sqrt();
    let half = T::from_ratio(1, 2);
    // The sum that does not cancel; the other square follows from x y = W²/4.
    let large = square.select_le(T::ZERO, square - root, square + root) * half;
    let small = product * T::from_ratio(1, 4) / large;
    let of_large = bivector.geometric(large + large) - turned;
    let of_small = turned - bivector.geometric(small + small);
    let factor = half / (large - small);
    let (of_large, of_small) = (of_large.geometric(factor), of_small.geometric(factor));
    match (finite(of_large), finite(of_small)) {
        (Some(first), Some(second)) if small.all_le(large) => Split::Blades([first, second]),
        (Some(first), Some(second)) => Split::Blades([second, first]),
        _ => Split::NotFinite,
    }
}
