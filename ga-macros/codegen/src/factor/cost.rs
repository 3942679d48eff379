//! The cost model: what a straight-line body takes on a machine that multiplies and adds at once.

use std::ops::Add;

use ga_core::Rational;
use num_traits::{One, Signed};

use crate::poly::{Monomial, Poly};

/// Operation counts of a kernel, compared by fused operations first.
///
/// A product that joins a sum is one fused operation, a sum of `p` products therefore `p`. So
/// `a b + a c` costs as much as `a (b + c)`, of which the second has one multiplication less, and
/// naming a product in order to add it twice costs more than computing it twice.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Cost {
    /// Operations where a product and the addition that it joins are one; doublings are among them.
    pub fused: usize,
    /// Multiplications, doublings apart.
    pub multiplications: usize,
    /// Additions, subtractions and doublings.
    pub additions: usize,
}

impl Cost {
    /// So many multiplications and nothing else.
    pub fn multiplying(multiplications: usize) -> Cost {
        Cost {
            fused: multiplications,
            multiplications,
            additions: 0,
        }
    }

    /// The cost of one polynomial, evaluated term by term.
    pub fn of(poly: &Poly) -> Cost {
        let terms = poly
            .terms()
            .map(|(monomial, value)| Weight::of(monomial, value));
        terms.fold(Weight::default(), Weight::plus).cost()
    }
}

impl Add for Cost {
    type Output = Cost;

    fn add(self, other: Cost) -> Cost {
        Cost {
            fused: self.fused + other.fused,
            multiplications: self.multiplications + other.multiplications,
            additions: self.additions + other.additions,
        }
    }
}

/// What the terms of one sum contribute to its cost.
#[derive(Clone, Copy, Debug, Default)]
pub struct Weight {
    /// How many terms there are.
    pub terms: usize,
    /// How many of them are no product, and have to be added to each other.
    pub plain: usize,
    /// Multiplications, doublings apart.
    pub multiplications: usize,
    /// Doublings.
    pub doublings: usize,
}

impl Weight {
    /// The weight of `value` times a monomial.
    fn of(monomial: &Monomial, value: &Rational) -> Weight {
        let constant = match value.abs() {
            one if one.is_one() => Constant::One,
            two if two == Rational::from_integer(2) => Constant::Two,
            _ => Constant::Other,
        };
        Weight::product(monomial.degree(), constant)
    }

    /// The weight of the product of so many variables and a constant.
    pub fn product(degree: usize, constant: Constant) -> Weight {
        let products = match degree {
            0 => 0,
            _ => degree - 1,
        };
        let scaled = degree > 0;
        let multiplications = products + usize::from(scaled && constant == Constant::Other);
        let doublings = usize::from(scaled && constant == Constant::Two);
        Weight {
            terms: 1,
            plain: usize::from(multiplications + doublings == 0),
            multiplications,
            doublings,
        }
    }

    /// The weight of the terms of both.
    pub fn plus(self, other: Weight) -> Weight {
        Weight {
            terms: self.terms + other.terms,
            plain: self.plain + other.plain,
            multiplications: self.multiplications + other.multiplications,
            doublings: self.doublings + other.doublings,
        }
    }

    /// The weight without terms that are among these.
    pub fn minus(self, other: Weight) -> Weight {
        Weight {
            terms: self.terms - other.terms,
            plain: self.plain - other.plain,
            multiplications: self.multiplications - other.multiplications,
            doublings: self.doublings - other.doublings,
        }
    }

    /// What a sum of these terms costs: every product is one operation, the one that opens the
    /// sum or one that joins it; terms that are no products are added one after another.
    pub fn cost(self) -> Cost {
        Cost {
            fused: self.multiplications + self.doublings + self.plain.saturating_sub(1),
            multiplications: self.multiplications,
            additions: self.terms.saturating_sub(1) + self.doublings,
        }
    }
}

/// How a product is scaled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Constant {
    /// Not at all, or by the sign.
    One,
    /// By an addition to itself.
    Two,
    /// By a multiplication.
    Other,
}
