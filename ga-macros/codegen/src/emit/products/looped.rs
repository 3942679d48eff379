//! Products too long to unroll: loops over one table per algebra.

use std::fmt::Write;

use ga_core::{Product, Rational};
use num_traits::ToPrimitive;

use super::{Emitted, result_type};
use crate::emit::Generator;
use crate::emit::expression;
use crate::ledger::Entry;
use crate::poly::{Element, Monomial, Poly, Variable};

/// From how many terms on a product loops over the table of the algebra. Up to five dimensions
/// unrolled bodies are short enough; beyond eight, where types are sparse, the table of all
/// blades would be longer than they are.
pub fn loop_from(dimension: usize) -> usize {
    match dimension {
        6 => 600,
        7 | 8 => 128,
        _ => usize::MAX,
    }
}

/// Emits a product as a loop over the table of the algebra. Its polynomials would be long, so
/// only the blades that it can have are looked at.
pub fn emit_loop(generator: &mut Generator<'_>, product: Product, a: usize, b: usize) -> Emitted {
    let masks = |index: usize| -> Vec<u32> {
        generator
            .kind(index)
            .slots
            .iter()
            .map(|slot| slot.mask)
            .collect()
    };
    let reach = generator.tables.reach(product, &masks(a), &masks(b));
    if reach.blades.is_empty() {
        return Emitted::Vanishes;
    }
    let variable = Monomial::of(Variable {
        operand: 0,
        slot: 0,
    });
    let any = Poly::term(variable, Rational::from_integer(1));
    let element: Element = reach
        .blades
        .iter()
        .map(|mask| (*mask, any.clone()))
        .collect();
    let Some(result) = result_type(generator, product, &element) else {
        return Emitted::Nothing;
    };
    let (left, right, name) = (generator.name(a), generator.name(b), generator.name(result));
    let number = product == Product::ScalarProduct;
    let output = if number {
        "T".to_owned()
    } else {
        format!("{name}<T>")
    };
    let (trait_name, method) = (product.trait_name(), product.method());
    let documentation = format!(
        " {} A loop over the table of the geometric product, each term a product of two \
         coefficients with the sign or the factor of the table. Cost: at most {} \
         multiplications{}, {} additions.",
        product.doc(),
        reach.terms,
        if reach.integral {
            ""
        } else {
            " and as many by factors"
        },
        reach.terms,
    );
    let fractions = [a, b]
        .into_iter()
        .any(|index| generator.kind(index).has_fractions());
    let integral = reach.integral && !fractions;
    let (bound, call) = if integral {
        ("Number", "integral")
    } else {
        ("Field", "product")
    };
    let field = if number { ".s" } else { "" };
    let value =
        format!("TABLE.{call}::<_, _, {name}<T>>(algebra::Product::{product:?}, self, b){field}");
    let _ = writeln!(
        generator.source,
        "impl<T: {bound}> {trait_name}<{right}<T>> for {left}<T> {{ type Output = {output}; {} \
         fn {method}(self, b: {right}<T>) -> {output} {{ {value} }} }}",
        expression::doc(&documentation),
    );
    let fields = if number {
        1
    } else {
        generator.kind(result).field_count()
    };
    let function = format!("{left}.{method}({right})");
    generator.record(Entry {
        function,
        result: name,
        cost: None,
        fields,
        form: "loop".to_owned(),
    });
    Emitted::Loop
}

/// The table of the geometric product as one literal: for each pair of blades, in the order of
/// their bitmasks, the number of terms, then blade and coefficient number of each.
pub fn emit_table(generator: &mut Generator<'_>) {
    let count = 1_u32 << generator.model.dimension();
    let mut coefficients: Vec<Rational> = Vec::new();
    let mut entries: Vec<u8> = Vec::new();
    for i in 0..count {
        for j in 0..count {
            let row = generator.tables.blades(Product::Geometric, i, j);
            entries.push(byte(generator, row.len()));
            for (mask, value) in row.iter() {
                let number = coefficients.iter().position(|known| known == value);
                let number = number.unwrap_or_else(|| {
                    coefficients.push(*value);
                    coefficients.len() - 1
                });
                entries.extend([byte(generator, *mask as usize), byte(generator, number)]);
            }
        }
    }
    let fits =
        |value: &Rational| value.numer().to_i64().is_some() && value.denom().to_i64().is_some();
    if !coefficients.iter().all(fits) {
        generator.tables.overflow();
    }
    let literal = proc_macro2::Literal::byte_string(&entries);
    let numbers: Vec<String> = coefficients
        .iter()
        .map(|value| format!("({}, {})", value.numer(), value.denom()))
        .collect();
    let _ = writeln!(
        generator.source,
        "#[doc(hidden)] const TABLE: algebra::table::Table = algebra::table::Table::new({}, {literal}, &[{}]);",
        generator.model.dimension(),
        numbers.join(", ")
    );
}

/// A number of the table; more than 255 different coefficients are beyond it.
fn byte(generator: &Generator<'_>, number: usize) -> u8 {
    u8::try_from(number).unwrap_or_else(|_| {
        generator.tables.overflow();
        0
    })
}
