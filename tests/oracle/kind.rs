//! What a generated type stores, as data: which type is the smallest for a polynomial result.

use std::collections::BTreeMap;

use ga::core::ops::Element;
use ga::core::{Blade, Product, Rational};

use crate::reference::Oracle;

/// The coefficients of a type, stored and fixed.
#[derive(Clone, Debug, PartialEq)]
pub struct Kind {
    pub name: String,
    pub stored: Vec<u32>,
    pub fixed: Vec<(u32, Rational)>,
}

/// One coefficient of a result: for each pair of stored coefficients of the operands (none for
/// a fixed one) its factor.
pub type Polynomial = BTreeMap<(Option<u32>, Option<u32>), Rational>;

impl Kind {
    pub fn of<X: Element>() -> Kind {
        let path = std::any::type_name::<X>();
        let path = path.split('<').next().unwrap_or(path);
        Kind {
            name: path.rsplit("::").next().unwrap_or(path).to_owned(),
            stored: X::BLADES.iter().map(|(blade, _)| blade.mask()).collect(),
            fixed: X::FIXED
                .iter()
                .map(|(blade, sign, numerator, denominator)| {
                    let value = Rational::new(i128::from(*numerator), i128::from(*denominator));
                    (blade.mask(), value * Rational::from(i128::from(*sign)))
                })
                .collect(),
        }
    }

    /// The grades of all coefficients, as bits.
    pub fn grades(&self) -> u32 {
        let masks = self.stored.iter().chain(self.fixed.iter().map(|(m, _)| m));
        masks.fold(0, |set, mask| set | 1 << mask.count_ones())
    }

    /// Whether all blades are even or all are odd.
    pub fn is_pure(&self) -> bool {
        self.grades() & 0x5555_5555 == 0 || self.grades() & 0xAAAA_AAAA == 0
    }

    /// Whether every value of one type is a value of this one.
    pub fn holds_kind(&self, other: &Kind) -> bool {
        let mut element: BTreeMap<u32, Polynomial> = BTreeMap::new();
        for mask in &other.stored {
            element.insert(*mask, [((Some(*mask), None), Rational::ONE)].into());
        }
        for (mask, value) in &other.fixed {
            element.insert(*mask, [((None, None), *value)].into());
        }
        self.holds(&element)
    }

    fn holds(&self, element: &BTreeMap<u32, Polynomial>) -> bool {
        let known = |mask: &u32| {
            self.stored.contains(mask) || self.fixed.iter().any(|(fixed, _)| fixed == mask)
        };
        element.keys().all(known)
            && self.fixed.iter().all(|(mask, value)| {
                let constant = [((None, None), *value)];
                element.get(mask) == Some(&Polynomial::from(constant))
            })
    }

    /// The coefficients with their variables.
    fn slots(&self) -> impl Iterator<Item = (u32, Option<u32>, Rational)> {
        let stored = self.stored.iter().map(|m| (*m, Some(*m), Rational::ONE));
        stored.chain(self.fixed.iter().map(|(m, value)| (*m, None, *value)))
    }
}

/// The product of the general values of two types.
pub fn general_product(
    oracle: &Oracle,
    product: Product,
    a: &Kind,
    b: &Kind,
) -> BTreeMap<u32, Polynomial> {
    let mut result: BTreeMap<u32, Polynomial> = BTreeMap::new();
    for (left, i, x) in a.slots() {
        for (right, j, y) in b.slots() {
            for (mask, value) in oracle.blades(product, left, right).iter() {
                let entry = result.entry(*mask).or_default().entry((i, j));
                match i.is_some() && j.is_some() {
                    true => *entry.or_insert(Rational::ZERO) = *value,
                    false => *entry.or_insert(Rational::ZERO) += *value * x * y,
                }
            }
        }
    }
    for polynomial in result.values_mut() {
        polynomial.retain(|_, value| *value != Rational::ZERO);
    }
    result.retain(|_, polynomial| !polynomial.is_empty());
    result
}

/// The fewest fields of a type that holds the product; `None` where no type does.
pub fn fewest_fields(oracle: &Oracle, product: Product, a: &Kind, b: &Kind) -> Option<usize> {
    let element = general_product(oracle, product, a, b);
    let holding = oracle.kinds.iter().filter(|kind| kind.holds(&element));
    holding.map(|kind| kind.stored.len()).min()
}

/// Whether some value of the type may have an inverse by its reverse: ⟨X X̃⟩ is not always zero.
pub fn has_norm(oracle: &Oracle, a: &Kind) -> bool {
    let mut norm: BTreeMap<Vec<Option<u32>>, Rational> = BTreeMap::new();
    for (left, i, x) in a.slots() {
        for (right, j, y) in a.slots() {
            let grade = Blade::new(right).grade();
            let sign = if grade % 4 > 1 {
                -Rational::ONE
            } else {
                Rational::ONE
            };
            for (_, value) in oracle.blades(Product::ScalarProduct, left, right).iter() {
                let mut monomial = vec![i, j];
                monomial.sort();
                *norm.entry(monomial).or_insert(Rational::ZERO) += *value * x * y * sign;
            }
        }
    }
    norm.values().any(|value| *value != Rational::ZERO)
}
