//! Products too long to unroll: loops over one table per algebra.

use std::fmt::Write;

use ga_core::{Metric, Product, Rational};
use num_traits::ToPrimitive;

use super::matrices::{emit_direct, is_iterated, matrices};
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
    let mut entry = Entry {
        function: format!("{left}.{method}({right})"),
        result: name.clone(),
        cost: None,
        fields: if number {
            1
        } else {
            generator.kind(result).field_count()
        },
        form: "loop".to_owned(),
    };
    let (mut documentation, mut value) = (documentation, value);
    let matrices = matrices(generator, product, [a, b], result);
    if matrices.is_some() || is_iterated(generator, product, [a, b]) {
        emit_direct(generator, [left.as_str(), &right, &name], bound, &value);
    }
    if let Some(matrices) = matrices {
        documentation = matrices.documentation(product);
        value = matrices.body;
        entry.form = matrices.form;
        entry.cost = Some(matrices.cost);
    }
    generator.record(entry);
    let _ = writeln!(
        generator.source,
        "impl<T: {bound}> {trait_name}<{right}<T>> for {left}<T> {{ type Output = {output}; {} \
         fn {method}(self, b: {right}<T>) -> {output} {{ {value} }} }}",
        expression::doc(&documentation),
    );
    Emitted::Loop
}

/// The table of the geometric product: which vectors are negative or null where they are
/// orthogonal and of square 1, −1 or 0; otherwise one literal as `ga_core::table` describes it.
pub fn emit_table(generator: &mut Generator<'_>) {
    let dimension = generator.model.dimension();
    if let Some((negative, null)) = orthogonal(&generator.model.metric) {
        let _ = writeln!(
            generator.source,
            "#[doc(hidden)] const TABLE: algebra::table::Table = \
             algebra::table::Table::orthogonal({dimension}, {negative}, {null});"
        );
        return;
    }
    let count = 1_u32 << dimension;
    let mut coefficients: Vec<Rational> = Vec::new();
    let mut entries: Vec<u8> = Vec::new();
    for i in 0..count {
        let mut line: Vec<u8> = Vec::new();
        for j in 0..count {
            let row = generator.tables.blades(Product::Geometric, i, j);
            line.push(byte(generator, row.len()));
            for (mask, value) in row.iter() {
                let number = coefficients.iter().position(|known| known == value);
                let number = number.unwrap_or_else(|| {
                    coefficients.push(*value);
                    coefficients.len() - 1
                });
                line.extend([byte(generator, *mask as usize), byte(generator, number)]);
            }
        }
        let length = u16::try_from(line.len()).unwrap_or_else(|_| {
            generator.tables.overflow();
            0
        });
        entries.extend(length.to_le_bytes());
        entries.extend(line);
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
        "#[doc(hidden)] const TABLE: algebra::table::Table = algebra::table::Table::new({dimension}, {literal}, &[{}]);",
        numbers.join(", ")
    );
}

/// The vectors of square −1 and those of square 0, as bits, of a metric of orthogonal vectors of
/// square 1, −1 or 0.
fn orthogonal(metric: &Metric) -> Option<(u32, u32)> {
    let (mut negative, mut null) = (0, 0);
    for i in 0..metric.dimension() {
        match (metric.gram(i, i).numer(), metric.gram(i, i).denom()) {
            (1, 1) => {}
            (-1, 1) => negative |= 1 << i,
            (0, _) => null |= 1 << i,
            _ => return None,
        }
    }
    metric.is_diagonal().then_some((negative, null))
}

/// A number of the table; more than 255 different coefficients are beyond it.
fn byte(generator: &Generator<'_>, number: usize) -> u8 {
    u8::try_from(number).unwrap_or_else(|_| {
        generator.tables.overflow();
        0
    })
}
