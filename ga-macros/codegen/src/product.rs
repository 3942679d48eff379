//! Products of general elements: one polynomial per blade of the result.

use std::cell::{Cell, RefCell};
use std::collections::{BTreeSet, HashMap};
use std::rc::Rc;

use ga_core::product::Rule;
use ga_core::{Blade, Metric, Product, Rational};

use crate::poly::Element;

type Row = Rc<[(u32, Rational)]>;

/// What is known of a product without its polynomials.
pub struct Reach {
    /// The blades it can have.
    pub blades: BTreeSet<u32>,
    /// The number of its terms.
    pub terms: usize,
    /// How many of them have another factor than ±1.
    pub factors: usize,
    /// Whether all its coefficients are integers.
    pub integral: bool,
}

/// The multiplication tables of one metric, filled as they are asked for.
pub struct Tables<'m> {
    metric: &'m Metric,
    rows: RefCell<HashMap<(Product, u32, u32), Row>>,
    overflow: Cell<bool>,
}

impl<'m> Tables<'m> {
    /// Empty tables of a metric.
    pub fn new(metric: &'m Metric) -> Self {
        Tables {
            metric,
            rows: RefCell::default(),
            overflow: Cell::new(false),
        }
    }

    /// Whether any blade product left exact arithmetic.
    pub fn overflowed(&self) -> bool {
        self.overflow.get()
    }

    /// Notes that exact arithmetic was left.
    pub fn overflow(&self) {
        self.overflow.set(true);
    }

    /// The product of two basis blades.
    pub fn blades(&self, which: Product, a: u32, b: u32) -> Row {
        if let Some(row) = self.rows.borrow().get(&(which, a, b)) {
            return Rc::clone(row);
        }
        let product = ga_core::product::product(self.metric, which, Blade::new(a), Blade::new(b));
        if product.is_none() {
            self.overflow.set(true);
        }
        let row: Row = product
            .unwrap_or_default()
            .into_iter()
            .map(|(blade, value)| (blade.mask(), value))
            .collect();
        self.rows
            .borrow_mut()
            .insert((which, a, b), Rc::clone(&row));
        row
    }

    /// What a product of two lists of blades can reach.
    pub fn reach(&self, which: Product, a: &[u32], b: &[u32]) -> Reach {
        let mut reach = Reach {
            blades: BTreeSet::new(),
            terms: 0,
            factors: 0,
            integral: true,
        };
        let mut add = |mask: u32, value: &Rational| {
            reach.blades.insert(mask);
            reach.terms += 1;
            let sign_alone = value.is_integer() && value.numer().unsigned_abs() == 1;
            reach.factors += usize::from(!sign_alone);
            reach.integral &= value.is_integer();
        };
        for left in a {
            for right in b {
                // One table serves all products that are parts of the geometric product.
                match which.row().rule {
                    Rule::Grades(keep) => {
                        let row = self.blades(Product::Geometric, *left, *right);
                        let grades = (left.count_ones(), right.count_ones());
                        row.iter()
                            .filter(|(mask, _)| keep(grades.0, grades.1, mask.count_ones()))
                            .for_each(|(mask, value)| add(*mask, value));
                    }
                    Rule::Complements => {
                        let row = self.blades(which, *left, *right);
                        row.iter().for_each(|(mask, value)| add(*mask, value));
                    }
                }
            }
        }
        reach
    }

    /// The product of two elements; `wanted` says which blades of the result are of interest.
    pub fn product_onto(
        &self,
        which: Product,
        a: &Element,
        b: &Element,
        wanted: impl Fn(u32) -> bool,
    ) -> Element {
        let mut result = Element::new();
        for (left, left_poly) in a {
            for (right, right_poly) in b {
                for (mask, value) in self.blades(which, *left, *right).iter() {
                    if wanted(*mask) {
                        result
                            .entry(*mask)
                            .or_default()
                            .add_product(left_poly, right_poly, value);
                    }
                }
            }
        }
        result.retain(|_, poly| !poly.is_zero());
        if result.values().any(|poly| poly.overflowed()) {
            self.overflow.set(true);
        }
        result
    }

    /// The whole product of two elements.
    pub fn product(&self, which: Product, a: &Element, b: &Element) -> Element {
        self.product_onto(which, a, b, |_| true)
    }
}
