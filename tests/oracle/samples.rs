//! Values to compare on: random fractions, and versors found among the values of a type.

use ga::core::ops::Element;
use ga::core::{Product, Rational};

use crate::kind::Kind;
use crate::reference::{Oracle, Value};

/// Numbers that are the same in every run.
pub struct Samples(u64);

impl Samples {
    pub fn new(seed: u64) -> Samples {
        Samples(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1)
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
    pub fn fraction(&mut self) -> Rational {
        match self.next() % 8 {
            0 => Rational::ZERO,
            1 => self.integer(99) / Rational::from_integer(2),
            2 => self.integer(99) / Rational::from_integer(3),
            _ => self.integer(999),
        }
    }

    /// An element with all coefficients random.
    pub fn full<X: Element<Number = Rational>>(&mut self) -> X {
        X::from_fn(|_| self.fraction())
    }

    /// An element with about `count` small coefficients.
    pub fn sparse<X: Element<Number = Rational>>(&mut self, count: usize) -> X {
        let length = X::BLADES.len();
        X::from_fn(|_| match self.below(length) < count {
            true => self.integer(3),
            false => Rational::ZERO,
        })
    }

    /// A number between −1 and 1.
    pub fn float(&mut self) -> f64 {
        (self.next() % 20_001) as f64 / 10_000.0 - 1.0
    }
}

/// Pairs of small numbers with rational roots of the sum or of the difference of their squares.
const TRIPLES: [(i128, i128); 4] = [(3, 4), (5, 3), (5, 4), (5, 12)];

/// Versors of a type: single blades, sums of few blades and products of these, as far as the
/// type holds them; of norm 1 for a type that is declared so.
pub fn versors<V: Element<Number = Rational>>(oracle: &Oracle) -> Vec<V> {
    let kind = Kind::of::<V>();
    let known = oracle.versors.borrow().get(&kind.name).cloned();
    let chosen = known.unwrap_or_else(|| search::<V>(oracle, &kind));
    let list = chosen.iter().filter_map(|value| oracle.element(value));
    let list = list.collect();
    oracle.versors.borrow_mut().insert(kind.name, chosen);
    list
}

fn search<V: Element<Number = Rational>>(oracle: &Oracle, kind: &Kind) -> Vec<Value> {
    let unit = oracle.units.contains(&kind.name.as_str());
    let mut samples = Samples::new(V::BLADES.len() as u64 + 7);
    let mut found: Vec<Value> = Vec::new();
    let length = V::BLADES.len();
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
        let candidate = oracle.value(&V::from_fn(|position| numbers[position]));
        found.extend(accepted::<V>(oracle, &candidate, unit));
    }
    let first = found.len();
    for _ in 0..if first == 0 { 0 } else { 24 } {
        let (left, right) = (samples.below(found.len()), samples.below(first));
        let product = oracle.product(Product::Geometric, &found[left], &found[right]);
        let small = product
            .iter()
            .all(|v| *v.numer() < 10_000 && *v.denom() < 10_000);
        if let Some(versor) = accepted::<V>(oracle, &product, unit).filter(|_| small) {
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
fn accepted<V: Element<Number = Rational>>(
    oracle: &Oracle,
    value: &Value,
    unit: bool,
) -> Option<Value> {
    let dense = oracle.dense(value);
    let square = dense.geometric(&dense.reverse()).ok()?;
    let norm = square.coefficient(ga::core::Blade::SCALAR);
    if norm == Rational::ZERO || !square.sub(&oracle.algebra.scalar(norm)).ok()?.is_zero() {
        return None;
    }
    for axis in 0..oracle.dimension {
        let blade = ga::core::Blade::new(1 << axis);
        let vector = oracle.algebra.blade(blade, Rational::ONE).ok()?;
        let image = dense
            .geometric(&vector)
            .ok()?
            .geometric(&dense.reverse())
            .ok()?;
        if image.terms().iter().any(|(blade, _)| blade.grade() != 1) {
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
    oracle.element::<V>(&value).map(|_| value)
}
