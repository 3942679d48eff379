//! Products too long to unroll, as loops over a table of the geometric product.

use crate::dual::{left_complement, right_complement};
use crate::ops::Element;
use crate::product::Rule;
use crate::{Blade, Field, Product, Scalar, reorder_sign};

/// The most blades of an algebra whose products loop: eight dimensions.
const BLADES: usize = 256;

/// The geometric product of all pairs of basis blades, in the order of their bitmasks: for
/// each pair the number of terms, then for each term the bitmask and the number of its
/// coefficient.
pub struct Table {
    dimension: u32,
    entries: &'static [u8],
    coefficients: &'static [(i64, i64)],
}

impl Table {
    /// A table made by the code generator.
    pub const fn new(
        dimension: u32,
        entries: &'static [u8],
        coefficients: &'static [(i64, i64)],
    ) -> Table {
        Table {
            dimension,
            entries,
            coefficients,
        }
    }

    /// The parts of the geometric product that the rule of `product` keeps.
    pub fn product<A, B, R>(&self, product: Product, a: A, b: B) -> R
    where
        A: Element,
        B: Element<Number = A::Number>,
        R: Element<Number = A::Number>,
        A::Number: Field,
    {
        self.product_over(product, a, b, A::Number::from_ratio)
    }

    /// [`product`](Table::product) over any ring, where no fraction takes part.
    pub fn integral<A, B, R>(&self, product: Product, a: A, b: B) -> R
    where
        A: Element,
        B: Element<Number = A::Number>,
        R: Element<Number = A::Number>,
    {
        self.product_over(product, a, b, |numerator, _| {
            A::Number::from_integer(numerator)
        })
    }

    fn product_over<A, B, R>(
        &self,
        product: Product,
        a: A,
        b: B,
        number: impl Fn(i64, i64) -> A::Number,
    ) -> R
    where
        A: Element,
        B: Element<Number = A::Number>,
        R: Element<Number = A::Number>,
    {
        let (left, right) = (spread(&a, &number), spread(&b, &number));
        let Rule::Grades(keep) = product.row().rule else {
            return gather(&regressive(self.dimension as usize, &left, &right));
        };
        let zero = A::Number::ZERO;
        let mut result = [zero; BLADES];
        let count = 1_u32 << self.dimension;
        let mut entries = self.entries;
        for i in 0..count {
            for j in 0..count {
                let Some((&terms, rest)) = entries.split_first() else {
                    break;
                };
                let (row, rest) = rest.split_at(2 * usize::from(terms));
                entries = rest;
                let factor = left[i as usize] * right[j as usize];
                if factor == zero {
                    continue;
                }
                for term in row.chunks_exact(2) {
                    let mask = u32::from(term[0]);
                    if keep(i.count_ones(), j.count_ones(), mask.count_ones()) {
                        let (numerator, denominator) = self.coefficients[usize::from(term[1])];
                        let value = match (numerator, denominator) {
                            (1, 1) => factor,
                            (-1, 1) => -factor,
                            _ => factor * number(numerator, denominator),
                        };
                        result[mask as usize] += value;
                    }
                }
            }
        }
        gather(&result)
    }
}

/// The coefficients by bitmask, with fixed ones written by `number`.
fn spread<A: Element>(a: &A, number: impl Fn(i64, i64) -> A::Number) -> [A::Number; BLADES] {
    let mut result = [A::Number::ZERO; BLADES];
    for (i, (blade, sign)) in A::BLADES.iter().enumerate() {
        result[blade.mask() as usize] = if *sign < 0 { -a.at(i) } else { a.at(i) };
    }
    for (blade, sign, numerator, denominator) in A::FIXED {
        let value = number(*numerator, *denominator);
        result[blade.mask() as usize] = if *sign < 0 { -value } else { value };
    }
    result
}

fn gather<R: Element>(coefficients: &[R::Number; BLADES]) -> R {
    R::from_fn(|i| {
        let (blade, sign) = R::BLADES[i];
        let value = coefficients[blade.mask() as usize];
        if sign < 0 { -value } else { value }
    })
}

/// The regressive product, which needs no metric.
fn regressive<T: Scalar>(dimension: usize, left: &[T; BLADES], right: &[T; BLADES]) -> [T; BLADES] {
    let mut result = [T::ZERO; BLADES];
    let count = 1_u32 << dimension;
    for i in (0..count).filter(|i| left[*i as usize] != T::ZERO) {
        let (below_left, left_sign) = right_complement(dimension, Blade::new(i));
        for j in (0..count).filter(|j| right[*j as usize] != T::ZERO) {
            let (below_right, right_sign) = right_complement(dimension, Blade::new(j));
            let (x, y) = (below_left.mask(), below_right.mask());
            if x & y != 0 {
                continue;
            }
            let (blade, sign) = left_complement(dimension, Blade::new(x | y));
            let factor = left[i as usize] * right[j as usize];
            let sign = sign * left_sign * right_sign * reorder_sign(x, y);
            result[blade.mask() as usize] += if sign < 0 { -factor } else { factor };
        }
    }
    result
}
