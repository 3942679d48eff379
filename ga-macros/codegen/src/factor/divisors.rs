//! What can be taken out of sums: a sum of two terms that several multiples of it contain, or a
//! product of two values that several terms contain.

use super::cube::{Cube, Sum, Term};

/// A value worth a name if it is used often enough.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Divisor {
    /// `first + second`, without a common factor; the first cube is the smaller one.
    Sum(Cube, Cube),
    /// `first − second`, in the same order.
    Difference(Cube, Cube),
    /// The product of two values.
    Product(Cube),
}

impl Divisor {
    /// The divisor as a sum of its own.
    pub fn sum(self) -> Sum {
        let term = |cube, negative| Term { cube, negative };
        match self {
            Divisor::Sum(first, second) => vec![term(first, false), term(second, false)],
            Divisor::Difference(first, second) => vec![term(first, false), term(second, true)],
            Divisor::Product(cube) => vec![term(cube, false)],
        }
    }
}

/// Where a divisor occurs: the terms of a sum that are `± cofactor · divisor`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Occurrence {
    /// The place of the sum.
    pub sum: u16,
    /// The terms, twice the same for a product.
    pub terms: [u16; 2],
    /// What the divisor is multiplied with.
    pub cofactor: Cube,
    /// Whether the multiple is subtracted.
    pub negative: bool,
}

impl Occurrence {
    /// Whether the divisor can be worth a name without any other occurrence: as a sum that has a
    /// common factor.
    pub fn is_multiple(&self) -> bool {
        self.cofactor != Cube::ONE && self.terms[0] != self.terms[1]
    }
}

/// Hands on all divisors of one sum: every two terms over their common factors, and every two
/// factors of a term.
pub fn divisors(place: u16, sum: &Sum, mut found: impl FnMut(Divisor, Occurrence)) {
    for (i, term) in sum.iter().enumerate() {
        for (j, other) in sum.iter().enumerate().skip(i + 1) {
            let [mut first, mut second, cofactor] = term.cube.apart(other.cube);
            let mut negative = term.negative;
            if second < first {
                std::mem::swap(&mut first, &mut second);
                negative = other.negative;
            }
            let divisor = match term.negative == other.negative {
                true => Divisor::Sum(first, second),
                false => Divisor::Difference(first, second),
            };
            let occurrence = Occurrence {
                sum: place,
                terms: [i as u16, j as u16],
                cofactor,
                negative,
            };
            found(divisor, occurrence);
        }
        products(term, |product| {
            let occurrence = Occurrence {
                sum: place,
                terms: [i as u16; 2],
                cofactor: term.cube.over(product),
                negative: term.negative,
            };
            found(Divisor::Product(product), occurrence);
        });
    }
}

/// Hands on every two factors of a term, once where a square makes them the same.
fn products(term: &Term, mut found: impl FnMut(Cube)) {
    let mut last = [0; 2];
    for (n, name) in term.cube.names().enumerate() {
        for other in term.cube.names().skip(n + 1) {
            if last != [name, other] {
                found(Cube::of(name).with(other));
            }
            last = [name, other];
        }
    }
}
