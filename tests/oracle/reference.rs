//! The dense algebra as a table of blade products, and exact values that can be compared.

use std::cell::RefCell;
use std::collections::HashMap;
use std::rc::Rc;

use ga::core::dense::{Algebra, Dense};
use ga::core::ops::Element;
use ga::core::{Blade, Metric, Product, Rational};

use crate::kind::Kind;

/// Terms of a product of two blades.
type Row = Rc<[(u32, Rational)]>;

/// The coefficients by bitmask.
pub type Value = Vec<Rational>;

/// A metric with its dense algebra, and the types that are compared with it.
pub struct Oracle {
    pub algebra: Algebra<Rational>,
    pub dimension: usize,
    pub degenerate: bool,
    pub kinds: Vec<Kind>,
    /// The names of the types declared as unit versors.
    pub units: &'static [&'static str],
    /// Conversions between types that are not the identity of multivectors.
    pub embeddings: &'static [(&'static str, &'static str)],
    /// How many operations have been compared.
    pub compared: RefCell<usize>,
    /// The versors of each type, found when first asked for.
    pub versors: RefCell<HashMap<String, Vec<Value>>>,
    rows: RefCell<HashMap<(Product, u32, u32), Row>>,
}

impl Oracle {
    pub fn new(metric: &Metric, units: &'static [&'static str], kinds: Vec<Kind>) -> Oracle {
        Oracle {
            algebra: Algebra::new(metric).expect("a metric within the oracle's reach"),
            dimension: metric.dimension(),
            degenerate: metric.is_degenerate(),
            kinds,
            units,
            embeddings: &[],
            compared: RefCell::new(0),
            versors: RefCell::default(),
            rows: RefCell::default(),
        }
    }

    /// The product of two basis blades, from the dense multivectors.
    pub fn blades(&self, product: Product, a: u32, b: u32) -> Row {
        if let Some(row) = self.rows.borrow().get(&(product, a, b)) {
            return Rc::clone(row);
        }
        let blade = |mask| self.algebra.blade(Blade::new(mask), Rational::ONE);
        let (left, right) = (blade(a).expect("a blade"), blade(b).expect("a blade"));
        let dense = left.product(product, &right).expect("one algebra");
        let row: Row = dense.terms().iter().map(|(b, v)| (b.mask(), *v)).collect();
        self.rows
            .borrow_mut()
            .insert((product, a, b), Rc::clone(&row));
        row
    }

    /// A product, by its bilinearity from those of the blades.
    pub fn product(&self, product: Product, a: &Value, b: &Value) -> Value {
        let mut result = self.zero();
        let present = |x: &Value| -> Vec<(u32, Rational)> {
            let terms = (0..).zip(x.iter().copied());
            terms
                .filter(|(_, value)| *value != Rational::ZERO)
                .collect()
        };
        let right = present(b);
        for (i, x) in present(a) {
            for (j, y) in &right {
                let row = self.blades(product, i, *j);
                let both = if row.is_empty() { x } else { x * *y };
                for (mask, factor) in row.iter() {
                    let simple = *factor == Rational::ONE;
                    result[*mask as usize] += if simple { both } else { both * *factor };
                }
            }
        }
        result
    }

    /// How often an operation is compared: in large algebras one sample has terms enough.
    pub fn repetitions(&self) -> usize {
        if self.dimension < 6 { 2 } else { 1 }
    }

    pub fn zero(&self) -> Value {
        vec![Rational::ZERO; 1 << self.dimension]
    }

    pub fn scalar(&self, number: Rational) -> Value {
        let mut value = self.zero();
        value[0] = number;
        value
    }

    /// All coefficients of an element, fixed ones included, by bitmask.
    pub fn value<X: Element<Number = Rational>>(&self, x: &X) -> Value {
        let mut value = self.zero();
        for (position, (blade, sign)) in X::BLADES.iter().enumerate() {
            value[blade.mask() as usize] = x.at(position) * Rational::from(i128::from(*sign));
        }
        for (mask, fixed) in Kind::of::<X>().fixed {
            value[mask as usize] = fixed;
        }
        value
    }

    /// The element of a type with these coefficients, if the type holds them.
    pub fn element<X: Element<Number = Rational>>(&self, value: &Value) -> Option<X> {
        let x = X::from_fn(|position| {
            let (blade, sign) = X::BLADES[position];
            value[blade.mask() as usize] * Rational::from(i128::from(sign))
        });
        (self.value(&x) == *value).then_some(x)
    }

    pub fn dense(&self, value: &Value) -> Dense<Rational> {
        let dense = self.algebra.from_coefficients(value.clone());
        dense.expect("as many coefficients as blades")
    }

    /// The coefficients of the grades that are bits of `grades`.
    pub fn restricted(&self, value: &Value, grades: u32) -> Value {
        let kept = |mask: u32| grades >> mask.count_ones() & 1 == 1;
        let terms = (0..).zip(value);
        terms
            .map(|(mask, v)| if kept(mask) { *v } else { Rational::ZERO })
            .collect()
    }

    /// Compares a generated result with the expected one.
    #[track_caller]
    pub fn same(&self, what: &str, operands: &[&Value], generated: &Value, expected: &Value) {
        *self.compared.borrow_mut() += 1;
        if generated != expected {
            let show = |value: &Value| {
                let terms = self.dense(value).terms();
                let text: Vec<String> = terms
                    .iter()
                    .map(|(b, v)| format!("{v}·{:b}", b.mask()))
                    .collect();
                text.join(" + ")
            };
            let operands: Vec<String> = operands.iter().map(|value| show(value)).collect();
            panic!(
                "{what}\n of {}\n gave {}\n instead of {}",
                operands.join("\n and "),
                show(generated),
                show(expected)
            );
        }
    }
}
