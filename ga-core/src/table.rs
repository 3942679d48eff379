//! Products too long to unroll, as loops over the blades that the operands have.

mod operand;
mod orthogonal;
mod rows;

use crate::ops::Element;
use crate::product::Rule;
use crate::{Field, Product, Scalar};

use operand::{BLADES, Operand, gather};

/// The geometric product of all pairs of basis blades.
#[derive(Clone, Copy, Debug)]
pub struct Table {
    dimension: u32,
    products: Products,
}

#[derive(Clone, Copy, Debug)]
enum Products {
    /// Basis vectors are orthogonal and square to 1, to −1 (bits of `negative`) or to 0.
    Orthogonal { negative: u32, null: u32 },
    /// Any metric, all products spelled out.
    Rows(rows::Rows),
}

impl Table {
    /// The table of orthogonal vectors of square 1, but −1 or 0 where a bit is set.
    pub const fn orthogonal(dimension: u32, negative: u32, null: u32) -> Table {
        Table {
            dimension,
            products: Products::Orthogonal { negative, null },
        }
    }

    /// A table made by the code generator: for each left blade, in the order of bitmasks, the
    /// number of bytes that follow for it, in two bytes of which the lower stands first; then
    /// for each right blade the number of terms, and for each term its bitmask and the number
    /// of its coefficient.
    pub const fn new(
        dimension: u32,
        entries: &'static [u8],
        coefficients: &'static [(i64, i64)],
    ) -> Table {
        Table {
            dimension,
            products: Products::Rows(rows::Rows {
                entries,
                coefficients,
            }),
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
        let (left, right) = (Operand::of(&a, &number), Operand::of(&b, &number));
        let mut result = [A::Number::ZERO; BLADES];
        match (product.row().rule, &self.products) {
            (Rule::Complements, _) => {
                // The outer product needs no metric.
                let dimension = self.dimension as usize;
                let (left, right) = (left.complements(dimension), right.complements(dimension));
                let Rule::Grades(keep) = Product::Wedge.row().rule else {
                    return gather(&result);
                };
                orthogonal::add(&left, &right, 0, 0, keep, &mut result);
                return gather(&operand::left_complements(dimension, &result));
            }
            (Rule::Grades(keep), Products::Orthogonal { negative, null }) => {
                orthogonal::add(&left, &right, *negative, *null, keep, &mut result);
            }
            (Rule::Grades(keep), Products::Rows(rows)) => {
                rows.add(self.dimension, &left, &right, keep, number, &mut result);
            }
        }
        gather(&result)
    }
}
