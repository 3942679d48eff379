//! What a generated type stores, as data.

use std::collections::BTreeSet;

use ga::core::Rational;
use ga::core::ops::Element;

use crate::operation::Numbers;
use crate::polynomial::{General, Polynomial, variable};
use crate::reference::Oracle;

/// The coefficients of a type, stored and fixed.
#[derive(Clone, Debug, PartialEq)]
pub struct Kind {
    pub name: String,
    /// The blades of the fields in their order.
    pub stored: Vec<u32>,
    /// The signs that their spellings have against the increasing order.
    pub signs: Vec<Rational>,
    pub fixed: Vec<(u32, Rational)>,
    /// Of a type declared null, the quadratic forms that vanish for its values.
    pub null: Vec<Form>,
}

/// Terms of two positions among the fields, that after the last for 1, and a factor.
type Form = Vec<(usize, usize, Rational)>;

impl Kind {
    pub fn of<X: Element>() -> Kind {
        let path = std::any::type_name::<X>();
        let path = path.split('<').next().unwrap_or(path);
        let sign = |sign: &i8| Rational::from(i128::from(*sign));
        Kind {
            name: path.rsplit("::").next().unwrap_or(path).to_owned(),
            stored: X::BLADES.iter().map(|(blade, _)| blade.mask()).collect(),
            signs: X::BLADES.iter().map(|(_, own)| sign(own)).collect(),
            fixed: X::FIXED
                .iter()
                .map(|(blade, own, numerator, denominator)| {
                    let value = Rational::new(i128::from(*numerator), i128::from(*denominator));
                    (blade.mask(), value * sign(own))
                })
                .collect(),
            null: X::NULL
                .iter()
                .map(|(_, form)| {
                    let terms = form.iter().map(|(first, second, numerator, denominator)| {
                        let factor =
                            Rational::new(i128::from(*numerator), i128::from(*denominator));
                        (*first, *second, factor)
                    });
                    terms.collect()
                })
                .collect(),
        }
    }

    /// The numbers as those of a value of the type: where it is declared null, a coefficient that
    /// the others determine is set so that the square vanishes.
    pub fn completed(&self, mut numbers: Numbers) -> Numbers {
        let length = numbers.len();
        for form in &self.null {
            let once = |(first, second, _): &&(usize, usize, Rational)| {
                let terms = form.iter();
                first != second && terms.filter(|t| t.0 == *first || t.1 == *first).count() == 1
            };
            let (own, other, factor) = *form.iter().find(once).expect("a linear coefficient");
            if other < length && numbers[other] == Rational::ZERO {
                numbers[other] = Rational::ONE;
            }
            let value = |position: usize| numbers.get(position).copied().unwrap_or(Rational::ONE);
            let factor = factor * value(other);
            let others = form.iter().filter(|(first, ..)| *first != own);
            let sum: Rational = others
                .map(|(first, second, f)| value(*first) * value(*second) * f)
                .sum();
            numbers[own] = -sum / factor;
        }
        numbers
    }

    /// Whether some values only of those with its blades are values of the type.
    pub fn is_constrained(&self) -> bool {
        !self.fixed.is_empty() || !self.null.is_empty()
    }

    /// The blades of all coefficients.
    pub fn blades(&self) -> BTreeSet<u32> {
        let fixed = self.fixed.iter().map(|(mask, _)| *mask);
        self.stored.iter().copied().chain(fixed).collect()
    }

    /// The grades of all coefficients, as bits.
    pub fn grades(&self) -> u32 {
        let blades = self.blades();
        blades
            .iter()
            .fold(0, |set, mask| set | 1 << mask.count_ones())
    }

    /// Whether all blades are odd.
    pub fn is_odd(&self) -> bool {
        self.grades() & 0x5555_5555 == 0
    }

    /// Whether all blades are even or all are odd.
    pub fn is_pure(&self) -> bool {
        self.is_odd() || self.grades() & 0xAAAA_AAAA == 0
    }

    /// The general value of the type, as the first or as the second operand.
    pub fn general(&self, operand: u32) -> General {
        let mut element = General::new();
        for mask in &self.stored {
            let monomial = [variable(operand, *mask), 0, 0];
            element.insert(*mask, [(monomial, Rational::ONE)].into());
        }
        for (mask, value) in &self.fixed {
            element.insert(*mask, constant(*value));
        }
        element
    }

    /// Whether every value of one type is a value of this one.
    pub fn holds_kind(&self, other: &Kind) -> bool {
        let null = self.null.is_empty() || !other.null.is_empty();
        null && self.fits(&other.general(0))
    }

    /// Whether every value of the element is a value of this type, whatever the element's square.
    pub fn holds(&self, element: &General) -> bool {
        self.null.is_empty() && self.fits(element)
    }

    /// Whether the type has all blades of the element, and the fixed coefficients are its own.
    pub fn fits(&self, element: &General) -> bool {
        let blades = self.blades();
        element.keys().all(|mask| blades.contains(mask))
            && self
                .fixed
                .iter()
                .all(|(mask, value)| element.get(mask) == Some(&constant(*value)))
    }
}

fn constant(value: Rational) -> Polynomial {
    [([0; 3], value)].into()
}

/// The declared type with the fewest fields that holds an element, of equals the first.
pub fn smallest<'o>(oracle: &'o Oracle, element: &General) -> Option<&'o Kind> {
    let mut kinds = oracle.kinds.iter();
    if element.is_empty() {
        return kinds.find(|kind| kind.name == "Scalar");
    }
    kinds
        .filter(|kind| kind.holds(element))
        .min_by_key(|kind| kind.stored.len())
}

/// The declared type with the fewest fields that has all these blades and fixes none.
pub fn free<'o>(oracle: &'o Oracle, blades: &BTreeSet<u32>) -> Option<&'o Kind> {
    let holds = |kind: &&Kind| !kind.is_constrained() && kind.blades().is_superset(blades);
    oracle
        .kinds
        .iter()
        .filter(holds)
        .min_by_key(|kind| kind.stored.len())
}
