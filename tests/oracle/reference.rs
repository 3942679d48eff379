//! The dense algebra as a table of blade products, and exact values that can be compared.

use std::cell::{Cell, RefCell};
use std::collections::HashMap;
use std::rc::Rc;

use ga::core::dense::{Algebra, Dense};
use ga::core::ops::Element;
use ga::core::{Blade, Metric, Product, Rational};

use crate::divisions::Divisor;
use crate::kind::Kind;
use crate::operation::{Numbers, numbers};
use crate::polynomial::reversal;
use crate::samples::Form;

/// Terms of a product of two blades.
type Row = Rc<[(u32, Rational)]>;

/// The coefficients by bitmask.
pub type Value = Vec<Rational>;

fn terms(dense: &Dense<Rational>) -> Row {
    let terms = dense.terms();
    terms.iter().map(|(blade, v)| (blade.mask(), *v)).collect()
}

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
    /// How many applications and how many matrices were compared.
    pub applications: Cell<usize>,
    pub matrices: Cell<usize>,
    /// The versors of each type, any and those of norm 1, found when first asked for.
    pub versors: RefCell<HashMap<(String, bool), Vec<Numbers>>>,
    /// Divisors of each type with their inverses, found when first asked for.
    pub divisors: RefCell<HashMap<String, Rc<[Divisor]>>>,
    rows: RefCell<HashMap<(Product, u32, u32), Row>>,
    complements: RefCell<HashMap<u32, [(u32, Rational); 2]>>,
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
            applications: Cell::new(0),
            matrices: Cell::new(0),
            versors: RefCell::default(),
            divisors: RefCell::default(),
            rows: RefCell::default(),
            complements: RefCell::default(),
        }
    }

    /// The product of two basis blades, from the dense multivectors.
    pub fn blades(&self, product: Product, a: u32, b: u32) -> Row {
        if let Some(row) = self.rows.borrow().get(&(product, a, b)) {
            return Rc::clone(row);
        }
        let row: Row = match product {
            // By its definition, complement by complement.
            Product::Regressive => {
                let ((a, x), (b, y)) = (self.complements(a)[1], self.complements(b)[1]);
                let spanned = self.blades(Product::Wedge, a, b);
                let joined = spanned.iter().map(|(mask, value)| {
                    let (image, sign) = self.complements(*mask)[0];
                    (image, *value * sign * x * y)
                });
                joined.collect()
            }
            _ => {
                let (left, right) = (self.blade(a), self.blade(b));
                let dense = left.product(product, &right).expect("one algebra");
                terms(&dense)
            }
        };
        self.rows
            .borrow_mut()
            .insert((product, a, b), Rc::clone(&row));
        row
    }

    fn blade(&self, mask: u32) -> Dense<Rational> {
        let blade = self.algebra.blade(Blade::new(mask), Rational::ONE);
        blade.expect("a blade of the algebra")
    }

    /// The left and the right complement of a basis blade, each a blade with its sign.
    fn complements(&self, mask: u32) -> [(u32, Rational); 2] {
        if let Some(known) = self.complements.borrow().get(&mask) {
            return *known;
        }
        let blade = self.blade(mask);
        let pair = [blade.left_complement(), blade.right_complement()].map(|x| terms(&x)[0]);
        self.complements.borrow_mut().insert(mask, pair);
        pair
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

    /// The samples on which every product is compared; in large algebras most are sparse.
    pub fn forms(&self) -> [Form; 4] {
        match self.dimension {
            0..6 => [
                Form::Fractions,
                Form::Sparse(2),
                Form::Integers,
                Form::Blade,
            ],
            _ => [
                Form::Sparse(3),
                Form::Sparse(8),
                Form::Blade,
                Form::Integers,
            ],
        }
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
        self.value_of(&Kind::of::<X>(), &numbers(x))
    }

    /// All coefficients of an element that is given by its type and what that stores.
    pub fn value_of(&self, kind: &Kind, numbers: &[Rational]) -> Value {
        assert_eq!(numbers.len(), kind.stored.len());
        let mut value = self.zero();
        for ((mask, sign), number) in kind.stored.iter().zip(&kind.signs).zip(numbers) {
            value[*mask as usize] = *number * *sign;
        }
        for (mask, fixed) in &kind.fixed {
            value[*mask as usize] = *fixed;
        }
        value
    }

    /// What a type stores of a value, if it holds that.
    pub fn numbers(&self, kind: &Kind, value: &Value) -> Option<Numbers> {
        let fields = kind.stored.iter().zip(&kind.signs);
        let numbers: Numbers = fields
            .map(|(mask, sign)| value[*mask as usize] * *sign)
            .collect();
        (self.value_of(kind, &numbers) == *value).then_some(numbers)
    }

    /// The value with every coefficient multiplied by the sign of its blade.
    pub fn signed(&self, value: &Value, sign: impl Fn(u32) -> Rational) -> Value {
        (0..).zip(value).map(|(mask, v)| *v * sign(mask)).collect()
    }

    /// The inverse: the reverse over X X̃ where that is a number, else that of the dense algebra.
    pub fn inverse(&self, value: &Value) -> Option<Value> {
        let reverse = self.signed(value, reversal);
        let square = self.product(Product::Geometric, value, &reverse);
        if square != self.scalar(square[0]) {
            let inverse = self.dense(value).inverse().ok()?;
            return Some(inverse.coefficients().to_vec());
        }
        let exists = square[0] != Rational::ZERO;
        exists.then(|| reverse.iter().map(|v| *v / square[0]).collect())
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
