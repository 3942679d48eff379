//! Which products are those of wider operands: where one operand is of a type that holds
//! everything of its parity, a body for the few blades of the other is not worth its tokens.

use ga_core::Product;

use super::looped::loop_from;
use super::{Call, applies, result_type};
use crate::emit::Generator;
use crate::emit::expression;
use crate::factor::{Cost, Kernel};

/// A product of two of the types `Even`, `Odd` and `Multivector`.
#[derive(Clone, Copy)]
pub struct Widened {
    result: usize,
    cost: Cost,
    integral: bool,
}

/// For a pair of a small type and one of `Even`, `Odd` and `Multivector`: the product of both
/// widened to the types of their parity, if that gives the same result type.
pub fn widened(
    generator: &mut Generator<'_>,
    product: Product,
    types: [usize; 2],
    result: usize,
) -> Option<Call> {
    if product == Product::ScalarProduct {
        return None;
    }
    let [a, b] = wide_types(generator, types)?;
    let key = (product.method(), a, b);
    let known = generator.widened.get(&key).copied();
    let wide = known.unwrap_or_else(|| derive(generator, product, [a, b]));
    generator.widened.insert(key, wide);
    // The caller asks for a ring, so what it calls must be content with one.
    let wide = wide.filter(|wide| wide.result == result && wide.integral)?;
    // What the operands do not have stays exactly zero.
    let form = match applies(generator, product, [a, b]) {
        true => "term_by_term",
        false => "widened",
    };
    Some(Call {
        form,
        words: format!("{} {}", generator.name(a), generator.name(b)),
        cost: Some(wide.cost),
    })
}

/// What a product of two types costs, given by its method, if it was emitted as one of wider types.
pub fn widened_cost(
    generator: &Generator<'_>,
    method: &'static str,
    types: [usize; 2],
    result: usize,
) -> Option<Cost> {
    let [a, b] = wide_types(generator, types)?;
    let wide = (*generator.widened.get(&(method, a, b))?)?;
    (wide.result == result && wide.integral).then_some(wide.cost)
}

/// The types of the parities of two operands, if one of these has such a type.
fn wide_types(generator: &Generator<'_>, [a, b]: [usize; 2]) -> Option<[usize; 2]> {
    let model = generator.model;
    if !model.is_complete() || model.dimension() < 4 {
        return None;
    }
    let complete = |index: usize| {
        let name = match generator.kind(index).parity() {
            Some(true) => "Even",
            Some(false) => "Odd",
            None => "Multivector",
        };
        model.type_named(name)
    };
    let wide = [complete(a)?, complete(b)?];
    let large = wide[0] == a || wide[1] == b;
    if wide == [a, b] || !large {
        return None;
    }
    // A loop would be slower than the few terms of the pair.
    let size: usize = wide.map(|i| generator.kind(i).slots.len()).iter().product();
    (size <= loop_from(model.dimension())).then_some(wide)
}

fn derive(generator: &Generator<'_>, product: Product, [a, b]: [usize; 2]) -> Option<Widened> {
    let (left, right) = (&generator.general[a][0], &generator.general[b][1]);
    let element = generator.tables.product(product, left, right);
    let result = result_type(generator, product, &element)?;
    let kernel = Kernel::expanded(generator.onto_fields(result, &element));
    Some(Widened {
        result,
        cost: kernel.cost(),
        integral: expression::is_integral(&kernel),
    })
}
