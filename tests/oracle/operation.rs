//! A generated operation as a function of plain numbers: what compares is compiled once, not
//! for every pair of types.

use std::marker::PhantomData;

use ga::core::Rational;
use ga::core::ops::Element;

/// The stored coefficients of an element in the order of its fields.
pub type Numbers = Vec<Rational>;

/// An operation of two elements.
pub type Binary = fn(&[Rational], &[Rational]) -> Numbers;

/// Several spellings of one operation of two elements.
pub type Spellings = fn(&[Rational], &[Rational]) -> Vec<Numbers>;

/// Stands for a pair of types; what is not generated falls back to a trait of absence.
pub struct Pair<A, B>(PhantomData<(A, B)>);

impl<A, B> Pair<A, B> {
    pub const fn new() -> Pair<A, B> {
        Pair(PhantomData)
    }
}

/// The element with these coefficients.
#[inline(never)]
pub fn element<X: Element<Number = Rational>>(numbers: &[Rational]) -> X {
    X::from_fn(|position| numbers[position])
}

/// The coefficients of an element.
#[inline(never)]
pub fn numbers<X: Element<Number = Rational>>(x: &X) -> Numbers {
    (0..X::BLADES.len())
        .map(|position| x.at(position))
        .collect()
}
