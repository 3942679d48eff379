//! Values to compare on: random fractions, and versors found among the values of a type.

use ga::core::ops::Element;
use ga::core::{Product, Rational};

use crate::kind::Kind;
use crate::operation::{Numbers, element};
use crate::polynomial::reversal;
use crate::reference::{Oracle, Value};

/// Numbers that are the same in every run.
pub struct Samples(u64);

/// Which coefficients of a sample differ from zero, and how large they are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Form {
    /// Fractions, one in eight of them zero.
    Fractions,
    /// Small integers, none of them zero.
    Integers,
    /// About so many small integers.
    Sparse(usize),
    /// A multiple of one basis blade.
    Blade,
}

impl Samples {
    pub fn new(seed: u64) -> Samples {
        Samples(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1)
    }

    /// The samples of a pair of types.
    pub fn of(left: &Kind, right: &Kind) -> Samples {
        Samples::new(left.stored.len() as u64 * 64 + right.stored.len() as u64)
    }

    fn next(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0 >> 16
    }

    /// An index below `count`.
    pub fn below(&mut self, count: usize) -> usize {
        (self.next() % count as u64) as usize
    }

    /// An integer up to `size` in absolute value, but not zero.
    pub fn integer(&mut self, size: i128) -> Rational {
        let number = 1 + i128::from(self.next()) % size;
        Rational::from_integer(if self.next() & 1 == 0 {
            number
        } else {
            -number
        })
    }

    /// A fraction; one value in eight is zero.
    fn fraction(&mut self) -> Rational {
        match self.next() % 8 {
            0 => Rational::ZERO,
            1 => self.integer(99) / Rational::from_integer(2),
            2 => self.integer(99) / Rational::from_integer(3),
            _ => self.integer(999),
        }
    }

    /// The coefficients of an element.
    pub fn numbers(&mut self, length: usize, form: Form) -> Numbers {
        let chosen = self.below(length);
        (0..length)
            .map(|position| match form {
                Form::Fractions => self.fraction(),
                Form::Integers => self.integer(3),
                Form::Sparse(count) if self.below(length) < count => self.integer(3),
                Form::Blade if position == chosen => self.integer(9),
                Form::Sparse(_) | Form::Blade => Rational::ZERO,
            })
            .collect()
    }

    /// An element with all coefficients random.
    pub fn full<X: Element<Number = Rational>>(&mut self) -> X {
        element(&self.numbers(X::BLADES.len(), Form::Fractions))
    }

    /// An element with about `count` small coefficients.
    pub fn sparse<X: Element<Number = Rational>>(&mut self, count: usize) -> X {
        element(&self.numbers(X::BLADES.len(), Form::Sparse(count)))
    }

    /// A number between −1 and 1.
    pub fn float(&mut self) -> f64 {
        (self.next() % 20_001) as f64 / 10_000.0 - 1.0
    }

    /// A number of thousandths between −1 and 1.
    pub fn thousandth(&mut self) -> Rational {
        Rational::new(i128::from(self.next() % 2_001) - 1_000, 1_000)
    }
}

/// Pairs of small numbers with rational roots of the sum or of the difference of their squares.
const TRIPLES: [(i128, i128); 4] = [(3, 4), (5, 3), (5, 4), (5, 12)];

/// Versors of a type: single blades, sums of few blades and products of these, as far as the
/// type holds them; of norm 1 for a type that is declared so.
pub fn versors(oracle: &Oracle, kind: &Kind) -> Vec<Numbers> {
    known(oracle, kind, oracle.units.contains(&kind.name.as_str()))
}

/// The same of norm 1, whether the type is declared so or not.
pub fn unit_versors(oracle: &Oracle, kind: &Kind) -> Vec<Numbers> {
    known(oracle, kind, true)
}

fn known(oracle: &Oracle, kind: &Kind, unit: bool) -> Vec<Numbers> {
    let key = (kind.name.clone(), unit);
    if let Some(known) = oracle.versors.borrow().get(&key) {
        return known.clone();
    }
    let chosen = search(oracle, kind, unit);
    let list = chosen
        .iter()
        .filter_map(|value| oracle.numbers(kind, value));
    let list: Vec<Numbers> = list.collect();
    oracle.versors.borrow_mut().insert(key, list.clone());
    list
}

fn search(oracle: &Oracle, kind: &Kind, unit: bool) -> Vec<Value> {
    let length = kind.stored.len();
    let mut samples = Samples::new(length as u64 + 7);
    let mut found: Vec<Value> = Vec::new();
    for attempt in 0..80 {
        let mut numbers = vec![Rational::ZERO; length];
        if attempt < length {
            numbers[attempt] = Rational::ONE;
        } else if attempt % 4 == 3 {
            // Every vector that is not null is a versor, and so is every quaternion.
            numbers.fill_with(|| samples.integer(5));
        } else {
            let (x, y) = TRIPLES[samples.below(TRIPLES.len())];
            numbers[samples.below(length)] = Rational::from_integer(x);
            numbers[samples.below(length)] = Rational::from_integer(y);
            if attempt % 3 == 0 {
                numbers[samples.below(length)] += samples.integer(3);
            }
        }
        let candidate = oracle.value_of(kind, &numbers);
        found.extend(accepted(oracle, kind, &candidate, unit));
    }
    let first = found.len();
    for _ in 0..if first == 0 { 0 } else { 24 } {
        let (left, right) = (samples.below(found.len()), samples.below(first));
        let product = oracle.product(Product::Geometric, &found[left], &found[right]);
        let small = product
            .iter()
            .all(|v| *v.numer() < 10_000 && *v.denom() < 10_000);
        if let Some(versor) = accepted(oracle, kind, &product, unit).filter(|_| small) {
            found.push(versor);
        }
    }
    // The products, which have most coefficients, come last.
    let mut chosen: Vec<Value> = Vec::new();
    for value in found.into_iter().rev() {
        if chosen.len() < 4 && !chosen.contains(&value) {
            chosen.push(value);
        }
    }
    chosen
}

/// The value, brought to norm 1 where that is wanted, if it is a versor that the type holds.
fn accepted(oracle: &Oracle, kind: &Kind, value: &Value, unit: bool) -> Option<Value> {
    let reverse = oracle.signed(value, reversal);
    let square = oracle.product(Product::Geometric, value, &reverse);
    let norm = square[0];
    if norm == Rational::ZERO || square != oracle.scalar(norm) {
        return None;
    }
    for axis in 0..oracle.dimension {
        let mut vector = oracle.zero();
        vector[1 << axis] = Rational::ONE;
        let image = oracle.product(Product::Geometric, value, &vector);
        let image = oracle.product(Product::Geometric, &image, &reverse);
        if image != oracle.restricted(&image, 0b10) {
            return None;
        }
    }
    let value: Value = if unit {
        let root = |n: i128| (0..=200_000).find(|r| r * r >= n).filter(|r| r * r == n);
        let size = Rational::new(root(*norm.numer())?, root(*norm.denom())?);
        value.iter().map(|v| *v / size).collect()
    } else {
        value.clone()
    };
    oracle.numbers(kind, &value).map(|_| value)
}
