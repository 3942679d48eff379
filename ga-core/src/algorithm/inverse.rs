//! The general inverse by the Faddeev–LeVerrier recursion.

use core::ops::Sub;

use super::parts::scalar;
use crate::Field;
use crate::ops::{Element, Geometric};

/// How many products [`adjugate`] takes in an algebra with `blades` basis blades: one less than
/// the order of its matrices.
pub const fn adjugate_products(blades: usize) -> usize {
    (1 << blades.trailing_zeros().div_ceil(2)) - 1
}

/// Adjugate and determinant of a multivector of an algebra with `blades` basis blades, by the
/// Faddeev–LeVerrier recursion: A⁻¹ = P / det.
///
/// `M` must hold the whole algebra, or an ideal-free subalgebra such as all even elements; its
/// products may have another type of the same blades.
pub fn adjugate<M>(a: M, blades: usize) -> (M, M::Number)
where
    M: Element + Geometric<M, Output: Into<M>> + Sub<Output = M>,
    M::Number: Field,
{
    let order = adjugate_products(blades) as i64 + 1;
    let mut adjugate = scalar::<M>(<M::Number as crate::Scalar>::ONE);
    let mut power = a;
    for step in 1..order {
        let trace = M::Number::from_ratio(order, step) * power.coefficient(crate::Blade::SCALAR);
        adjugate = power - scalar(trace);
        power = a.geometric(adjugate).into();
    }
    (adjugate, power.coefficient(crate::Blade::SCALAR))
}
