//! Which dense products go through matrices, and the constant that they need.

use std::fmt::Write;

use ga_core::Product;
use proc_macro2::Literal;

use crate::emit::Generator;
use crate::emit::versors::parity_type;
use crate::factor::Cost;
use crate::isomorphism::{self, Parity, Signed, Tables};
use crate::model::Type;

/// The way of a product through matrices.
pub struct Matrices {
    /// The expression of the product.
    pub body: String,
    /// Which matrices, for the ledger and the documentation.
    pub form: String,
    /// What it costs.
    pub cost: Cost,
}

impl Matrices {
    /// The documentation of the product.
    pub fn documentation(&self, product: Product) -> String {
        format!(
            " {} Through {}: zeros are rounding noise beside the largest coefficients; \
             `TermByTerm` keeps them. Exact numbers are multiplied term by term. Cost: {} \
             multiplications, {} additions.",
            product.doc(),
            self.form,
            self.cost.multiplications,
            self.cost.additions,
        )
    }
}

/// The way of the geometric product of two types through matrices, where measurement says that
/// it is faster than the direct one (`cargo bench --bench dense`): for types of all blades, or
/// of all even or all odd ones, from five dimensions on. In five, where the direct product is
/// unrolled, only if one product of matrices does.
pub fn matrices(
    generator: &Generator<'_>,
    product: Product,
    [a, b]: [usize; 2],
    result: usize,
) -> Option<Matrices> {
    let tables = tables(generator, product, [a, b])?;
    let (left, right) = (generator.kind(a), generator.kind(b));
    let mut terms = String::new();
    for term in &tables.terms {
        let _ = write!(
            terms,
            "algebra::matrix::Term {{ part: {}, left: {}, right: {} }},",
            term.part,
            literal(term.left.iter().map(|blade| position(left, *blade))),
            literal(term.right.iter().map(|blade| position(right, *blade))),
        );
    }
    let kind = generator.kind(result);
    let entries = kind
        .fields()
        .map(|slot| tables.entry(slot.mask, slot.sign < 0));
    let body = format!(
        "match T::HALF {{ Some(half) => {{ \
         const MATRICES: algebra::matrix::Isomorphism<'static, {}, {}, {}> = \
         algebra::matrix::Isomorphism {{ pairs: {}, terms: &[{terms}], result: {} }}; \
         {}::from(MATRICES.product(half, &self.to_array(), &b.to_array())) }} \
         None => algebra::ops::TermByTerm::term_by_term(self, b) }}",
        tables.height,
        tables.width,
        tables.units,
        tables.pairs,
        literal(entries),
        generator.name(result),
    );
    Some(Matrices {
        body,
        form: tables.name(),
        cost: tables.cost(),
    })
}

/// Whether a product goes through matrices.
pub fn applies(generator: &Generator<'_>, product: Product, types: [usize; 2]) -> bool {
    tables(generator, product, types).is_some()
}

fn tables(generator: &Generator<'_>, product: Product, types: [usize; 2]) -> Option<Tables> {
    let dimension = generator.model.dimension();
    if product != Product::Geometric || dimension < 5 || is_iterated(generator, product, types) {
        return None;
    }
    let [left, right] = types.map(|index| dense(generator.kind(index), dimension));
    let tables = isomorphism::tables(&generator.model.metric, left?, right?)?;
    (dimension > 5 || tables.terms.len() == 1).then_some(tables)
}

/// The direct product, for numbers that are exact and for products that must not round zeros.
pub fn emit_direct(
    generator: &mut Generator<'_>,
    [left, right, result]: [&str; 3],
    bound: &str,
    body: &str,
) {
    let _ = writeln!(
        generator.source,
        "impl<T: {bound}> algebra::ops::TermByTerm<{right}<T>> for {left}<T> {{ \
         type Output = {result}<T>; \
         algebra::inlined! {{ fn term_by_term(self, b: {right}<T>) -> {result}<T> {{ {body} }} }} }}",
    );
}

/// Whether roots and logarithms are iterated with a product: that of all even elements beyond five
/// dimensions. They need it term by term, because what is large beside the rest must cancel exactly.
pub fn is_iterated(generator: &Generator<'_>, product: Product, [a, b]: [usize; 2]) -> bool {
    let even = generator.kind(a).parity() == Some(true) && parity_type(generator, a) == Some(a);
    product == Product::Geometric && a == b && even && generator.model.dimension() > 5
}

/// The parity of a type that has all blades of its parity.
fn dense(kind: &Type, dimension: usize) -> Option<Parity> {
    let (parity, count) = match kind.parity() {
        Some(true) => (Parity::Even, 1 << (dimension - 1)),
        Some(false) => (Parity::Odd, 1 << (dimension - 1)),
        None => (Parity::Both, 1 << dimension),
    };
    (kind.field_count() == count && !kind.has_fixed()).then_some(parity)
}

/// The position of a blade among the fields, and whether the sign changes.
fn position(kind: &Type, blade: Signed) -> (usize, bool) {
    let mut fields = kind.fields().enumerate();
    match fields.find(|(_, slot)| slot.mask == blade.mask) {
        Some((position, slot)) => (position, blade.negative ^ (slot.sign < 0)),
        None => (0, false),
    }
}

/// A table as one literal: two bytes for each entry, the lower one first.
fn literal(entries: impl Iterator<Item = (usize, bool)>) -> Literal {
    let entry = |(position, negative): (usize, bool)| {
        let sign = if negative { 1 << 15 } else { 0 };
        (position as u16 | sign).to_le_bytes()
    };
    Literal::byte_string(&entries.flat_map(entry).collect::<Vec<u8>>())
}
