//! Polynomials in the coefficients of the operands: exact, and each monomial once.

use std::collections::BTreeMap;

use ga_core::Rational;
use num_traits::{CheckedAdd, CheckedMul, Zero};

use crate::model::Type;

/// A coefficient of an operand: the operand's number and the position of the slot.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Variable {
    /// Which operand: 0 for `self`, 1 for the argument.
    pub operand: u8,
    /// The position in the operand's slots.
    pub slot: u16,
}

/// A product of at most four variables, sorted; the unused places are `None` and stand first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Monomial([Option<Variable>; Monomial::LARGEST]);

impl Monomial {
    /// How many variables a product may have.
    pub const LARGEST: usize = 4;

    /// The empty product.
    pub const ONE: Monomial = Monomial([None; Monomial::LARGEST]);

    /// One variable.
    pub fn of(variable: Variable) -> Monomial {
        Monomial([None, None, None, Some(variable)])
    }

    /// The variables in order.
    pub fn variables(&self) -> impl Iterator<Item = Variable> + '_ {
        self.0.iter().copied().flatten()
    }

    /// The number of variables.
    pub fn degree(&self) -> usize {
        self.variables().count()
    }

    /// The product; degrees add up to at most four.
    pub fn times(&self, other: &Monomial) -> Monomial {
        let mut result = [None; Monomial::LARGEST];
        let factors = self.variables().chain(other.variables());
        for (place, factor) in result.iter_mut().zip(factors) {
            *place = Some(factor);
        }
        result.sort_unstable();
        Monomial(result)
    }

    /// The monomial in other variables.
    pub fn renamed(&self, name: impl Fn(Variable) -> Variable) -> Monomial {
        let mut result = self.0.map(|variable| variable.map(&name));
        result.sort_unstable();
        Monomial(result)
    }
}

/// A polynomial with exact coefficients.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Poly {
    terms: BTreeMap<Monomial, Rational>,
    overflow: bool,
}

impl Poly {
    /// A constant.
    pub fn constant(value: Rational) -> Poly {
        let mut poly = Poly::default();
        poly.add_term(Monomial::ONE, value);
        poly
    }

    /// `value` times one monomial.
    pub fn term(monomial: Monomial, value: Rational) -> Poly {
        let mut poly = Poly::default();
        poly.add_term(monomial, value);
        poly
    }

    /// The terms in order.
    pub fn terms(&self) -> impl Iterator<Item = (&Monomial, &Rational)> {
        self.terms.iter()
    }

    /// The coefficient of a monomial.
    pub fn coefficient(&self, monomial: &Monomial) -> Rational {
        self.terms
            .get(monomial)
            .copied()
            .unwrap_or_else(Rational::zero)
    }

    /// The number of terms.
    pub fn len(&self) -> usize {
        self.terms.len()
    }

    /// Whether no term is left, so that the polynomial vanishes identically.
    pub fn is_zero(&self) -> bool {
        self.terms.is_empty() && !self.overflow
    }

    /// Whether exact arithmetic overflowed on the way.
    pub fn overflowed(&self) -> bool {
        self.overflow
    }

    /// The value, if no variable occurs.
    pub fn as_constant(&self) -> Option<Rational> {
        match self.terms.len() {
            0 => Some(Rational::zero()),
            1 => self.terms.get(&Monomial::ONE).copied(),
            _ => None,
        }
    }

    /// Adds `value` times a monomial.
    pub fn add_term(&mut self, monomial: Monomial, value: Rational) {
        let entry = self.terms.entry(monomial).or_insert_with(Rational::zero);
        match added(entry, &value) {
            Some(sum) => *entry = sum,
            None => self.overflow = true,
        }
        if entry.is_zero() {
            self.terms.remove(&monomial);
        }
    }

    /// Adds `factor` times another polynomial.
    pub fn add_scaled(&mut self, other: &Poly, factor: &Rational) {
        self.overflow |= other.overflow;
        for (monomial, value) in &other.terms {
            match multiplied(value, factor) {
                Some(value) => self.add_term(*monomial, value),
                None => self.overflow = true,
            }
        }
    }

    /// Adds `factor` times the product of two polynomials.
    pub fn add_product(&mut self, left: &Poly, right: &Poly, factor: &Rational) {
        self.overflow |= left.overflow | right.overflow;
        for (monomial, value) in &left.terms {
            let Some(value) = multiplied(value, factor) else {
                self.overflow = true;
                continue;
            };
            for (other, other_value) in &right.terms {
                match multiplied(&value, other_value) {
                    Some(product) => self.add_term(monomial.times(other), product),
                    None => self.overflow = true,
                }
            }
        }
    }

    /// The polynomial times a number.
    pub fn scaled(&self, factor: &Rational) -> Poly {
        let mut result = Poly::default();
        result.add_scaled(self, factor);
        result
    }

    /// The polynomial with operands 0 and 1 exchanged.
    pub fn swapped(&self) -> Poly {
        self.renamed(|v| Variable {
            operand: 1 - v.operand,
            ..v
        })
    }

    /// The polynomial in other variables; different ones must stay different.
    pub fn renamed(&self, name: impl Fn(Variable) -> Variable) -> Poly {
        let terms = self
            .terms
            .iter()
            .map(|(m, value)| (m.renamed(&name), *value))
            .collect();
        Poly {
            terms,
            overflow: self.overflow,
        }
    }
}

/// The exact sum; integers, the usual case, are spared the search for common divisors.
fn added(a: &Rational, b: &Rational) -> Option<Rational> {
    if a.is_integer() && b.is_integer() {
        a.numer().checked_add(b.numer()).map(Rational::from_integer)
    } else {
        a.checked_add(b)
    }
}

/// The exact product; integers are spared the search for common divisors.
fn multiplied(a: &Rational, b: &Rational) -> Option<Rational> {
    if a.is_integer() && b.is_integer() {
        a.numer().checked_mul(b.numer()).map(Rational::from_integer)
    } else {
        a.checked_mul(b)
    }
}

/// A multivector whose coefficients are polynomials, by blade mask; absent blades are zero.
pub type Element = BTreeMap<u32, Poly>;

/// The general value of a type as an operand: a variable per field, constants where fixed.
pub fn general(kind: &Type, operand: u8) -> Element {
    let slots = kind.slots.iter().enumerate();
    slots
        .map(|(position, slot)| {
            let sign = Rational::from_integer(i128::from(slot.sign));
            let variable = Variable {
                operand,
                slot: position as u16,
            };
            let poly = match slot.fixed {
                Some(value) => Poly::constant(value * sign),
                None => Poly::term(Monomial::of(variable), sign),
            };
            (slot.mask, poly)
        })
        .collect()
}

/// An element with each grade multiplied by a sign.
pub fn graded_signs(element: &Element, sign: impl Fn(u32) -> i32) -> Element {
    element
        .iter()
        .map(|(mask, poly)| {
            let sign = Rational::from_integer(i128::from(sign(mask.count_ones())));
            (*mask, poly.scaled(&sign))
        })
        .collect()
}

/// `left + factor · right`.
pub fn sum(left: &Element, right: &Element, factor: i128) -> Element {
    let mut result = left.clone();
    for (mask, poly) in right {
        result
            .entry(*mask)
            .or_default()
            .add_scaled(poly, &Rational::from_integer(factor));
    }
    result.retain(|_, poly| !poly.is_zero());
    result
}
