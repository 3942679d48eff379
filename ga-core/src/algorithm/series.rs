//! The exponential of any element as a power series, for whatever has no closed form.

use core::ops::Add;

use super::parts::scalar;
use crate::ops::{Element, Geometric};
use crate::{Field, Real, Scalar};

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
    // Beyond 2^1100 nothing is finite in double precision.
    while !remaining.all_le(M::Number::from_integer(4)) && squarings < 1100 {
        argument = argument.geometric(half);
        remaining *= half;
        squarings += 1;
    }
    let mut term = scalar::<M>(M::Number::ONE);
    let mut sum = term;
    // Metrics with large entries converge later than the coefficients suggest.
    for step in 1..=200_i64 {
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
