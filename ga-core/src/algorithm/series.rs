//! The exponential of any element as a power series, for whatever has no closed form.

use core::ops::Add;

use super::parts::scalar;
use crate::ops::{Element, Geometric};
use crate::{Field, Real, Scalar};

/// How many terms of the power series are summed at most. Metrics with large entries converge
/// later than the coefficients suggest.
pub const MOST_TERMS: usize = 200;
/// How many terms are summed at most where basis blades multiply to a basis blade, its negative
/// or zero. With coefficients that add up to no more than 4, those of the n-th term add up to no
/// more than 4ⁿ/n! and those of the sum to no less than e⁻⁴.
pub const ORTHONORMAL_TERMS: usize = 36;
/// How often the argument is halved at most: beyond 2^1100 nothing is finite in double precision.
pub const MOST_HALVINGS: usize = 1100;

/// The exponential by scaling and squaring: the argument is halved until its coefficients add
/// up to no more than four, the power series summed to rounding, the sum squared as often.
///
/// An argument that is not finite gives a result that is not finite.
pub fn exponential<M>(a: M) -> M
where
    M: Element + Geometric<M, Output: Into<M>> + Geometric<M::Number, Output = M> + Add<Output = M>,
    M::Number: Real,
{
    let half = M::Number::from_ratio(1, 2);
    let size = |x: &M| (0..M::BLADES.len()).fold(M::Number::ZERO, |sum, i| sum + x.at(i).abs());
    let mut argument = a;
    let mut remaining = size(&a);
    let mut squarings = 0;
    while !remaining.all_le(M::Number::from_integer(4)) && squarings < MOST_HALVINGS {
        argument = argument.geometric(half);
        remaining *= half;
        squarings += 1;
    }
    let mut term = scalar::<M>(M::Number::ONE);
    let mut sum = term;
    for step in 1..=MOST_TERMS as i64 {
        let next: M = term.geometric(argument).into();
        term = next.geometric(M::Number::from_ratio(1, step));
        sum = sum + term;
        let negligible = size(&sum) * M::Number::from_f64(1e-18);
        if step > 4 && size(&term).all_le(negligible) {
            break;
        }
    }
    for _ in 0..squarings {
        sum = sum.geometric(sum).into();
    }
    sum
}
