//! All products between all types: unrolled, handed on where another body is the same, or
//! listed where they vanish.

mod looped;
mod matrices;
mod widened;

use std::fmt::Write;

use ga_core::{Involution, Product, Rational};

pub use self::looped::loop_from;
use self::looped::{emit_loop, emit_table};
use self::matrices::{applies, emit_direct, is_iterated, matrices};
use self::widened::widened;
pub use self::widened::{Widened, widened_cost};
use super::Generator;
use super::expression::{self, Names};
use super::unrolled::{self, Function, Lists};
use crate::closure;
use crate::factor::{Cost, Kernel};
use crate::ledger::Entry;
use crate::poly::{Element, Poly};

/// Emits every product of every ordered pair of types.
pub fn products(generator: &mut Generator<'_>) {
    let count = generator.model.types.len();
    let mut loops = false;
    for a in 0..count {
        let mut unrolled = Lists::new(generator.name(a));
        let mut vanishing: Vec<(Product, Vec<String>)> = Vec::new();
        let mut shared: Vec<(Product, Vec<String>)> = Vec::new();
        for b in 0..count {
            for &product in &generator.model.products {
                match emit_pair(generator, &mut unrolled, product, a, b) {
                    Emitted::Nothing | Emitted::Unrolled => {}
                    Emitted::Vanishes => add(&mut vanishing, product, generator.name(b)),
                    Emitted::Loop => loops = true,
                    Emitted::Shared(entry) => add(&mut shared, product, entry),
                }
            }
        }
        unrolled.write(&mut generator.source);
        let name = generator.name(a);
        for (product, list) in shared {
            let (trait_name, method) = (product.trait_name(), product.method());
            let number = if product == Product::ScalarProduct {
                "number"
            } else {
                ""
            };
            let _ = writeln!(
                generator.source,
                "algebra::shared! {{ {trait_name} {method} {name} {number}: {} }}",
                list.join(" ")
            );
        }
        for (product, list) in vanishing {
            let (trait_name, method) = (product.trait_name(), product.method());
            let result = if product == Product::ScalarProduct {
                "number"
            } else {
                "Scalar"
            };
            let _ = writeln!(
                generator.source,
                "algebra::vanishing! {{ {result} {trait_name} {method} {name}: {} }}",
                list.join(", ")
            );
        }
    }
    if loops {
        emit_table(generator);
    }
}

/// The result type of an element; `None` where no declared type holds it.
fn result_type(generator: &Generator<'_>, product: Product, element: &Element) -> Option<usize> {
    if product == Product::ScalarProduct {
        return generator.model.type_named("Scalar");
    }
    closure::smallest(generator.model, element)
}

/// What became of one product of two types.
enum Emitted {
    /// No declared type holds it.
    Nothing,
    /// It is zero whatever the operands.
    Vanishes,
    /// A function with a body of its own.
    Unrolled,
    /// A function that loops over the table of the algebra.
    Loop,
    /// An entry of the list of functions that call another one.
    Shared(String),
}

/// Adds an entry to the list of a product.
fn add(lists: &mut Vec<(Product, Vec<String>)>, product: Product, entry: String) {
    match lists.iter_mut().find(|(known, _)| *known == product) {
        Some((_, list)) => list.push(entry),
        None => lists.push((product, vec![entry])),
    }
}

/// Emits one product of two types.
fn emit_pair(
    generator: &mut Generator<'_>,
    lists: &mut Lists,
    product: Product,
    a: usize,
    b: usize,
) -> Emitted {
    let size = generator.kind(a).slots.len() * generator.kind(b).slots.len();
    if size > loop_from(generator.model.dimension()) {
        return emit_loop(generator, product, a, b);
    }
    let (left, right) = (&generator.general[a][0], &generator.general[b][1]);
    let element = generator.tables.product(product, left, right);
    if element.is_empty() {
        return Emitted::Vanishes;
    }
    let Some(result) = result_type(generator, product, &element) else {
        return Emitted::Nothing;
    };
    emit_unrolled(generator, lists, product, [a, b], result, &element)
}

/// Emits a product with a body of its own, or as a call of one emitted before.
fn emit_unrolled(
    generator: &mut Generator<'_>,
    lists: &mut Lists,
    product: Product,
    [a, b]: [usize; 2],
    result: usize,
    element: &Element,
) -> Emitted {
    let names = Names::new(generator.kind(a), Some(("b", generator.kind(b))));
    let is_number = product == Product::ScalarProduct;
    let kernel = Kernel::expanded(generator.onto_fields(result, element));
    generator.check(&kernel);
    let integral = expression::is_integral(&kernel);
    let call = hand_on(generator, product, a, b, result, &kernel)
        .or_else(|| widened(generator, product, [a, b], result));
    let (left, right) = (generator.name(a), generator.name(b));
    let result_kind = (!is_number).then(|| generator.kind(result));
    let call = call.filter(|_| integral);
    let cost = call.as_ref().and_then(|call| call.cost);
    let cost = cost.unwrap_or_else(|| kernel.cost());
    let output = if is_number {
        "T".to_owned()
    } else {
        generator.name(result)
    };
    let mut entry = Entry {
        function: format!("{left}.{}({right})", product.method()),
        result: output.clone(),
        cost: None,
        fields: result_kind.map_or(1, |kind| kind.field_count()),
        form: String::new(),
    };
    if let Some(call) = call {
        entry.form = call.form.to_owned();
        generator.record(entry);
        let output = if is_number {
            String::new()
        } else {
            format!("=> {output}")
        };
        let documentation =
            expression::documentation_at(product.doc(), cost, &kernel, result_kind, &names);
        let text = format!(
            "{} {right} {output} ({}) {documentation:?},",
            call.form, call.words
        );
        return Emitted::Shared(text);
    }
    let kernel = kernel.factored();
    let documentation = expression::documentation(product.doc(), &kernel, result_kind, &names);
    entry.form = kernel.form.to_string();
    entry.cost = Some(kernel.cost());
    let mut body = expression::body(&kernel, result_kind, &names);
    let mut documentation = documentation;
    let matrices = matrices(generator, product, [a, b], result);
    if matrices.is_some() || is_iterated(generator, product, [a, b]) {
        let types = [left.as_str(), &right, &output];
        let direct = format!("algebra::kernel! {{ {body} }}");
        emit_direct(generator, types, unrolled::bound(&kernel), &direct);
    }
    if let Some(matrices) = matrices {
        documentation = matrices.documentation(product);
        body = matrices.body;
        entry.form = matrices.form;
        entry.cost = Some(matrices.cost);
    }
    generator.record(entry);
    let output = match is_number {
        true => output,
        false => format!("{output}<T>"),
    };
    lists.push(&Function {
        trait_name: product.trait_name(),
        method: product.method(),
        bound: unrolled::bound(&kernel),
        between: None,
        argument: ("b", &right),
        output: &output,
        documentation: &documentation,
        body: &body,
    });
    Emitted::Unrolled
}

/// How a function calls another one.
struct Call {
    /// The arm of `ga_core::shared!` that writes the call.
    form: &'static str,
    /// The method, or the two types that the operands are widened to.
    words: String,
    /// What the other function costs, if not what this one would.
    cost: Option<Cost>,
}

/// The call of a function emitted before with the same polynomials: another product of the
/// same operands, or of the operands exchanged, up to sign.
fn hand_on(
    generator: &mut Generator<'_>,
    product: Product,
    a: usize,
    b: usize,
    result: usize,
    kernel: &Kernel,
) -> Option<Call> {
    if product == Product::ScalarProduct {
        return hand_on_number(generator, a, b, result, kernel);
    }
    let minus = Rational::from_integer(-1);
    let negated =
        |polys: &[Poly]| -> Vec<Poly> { polys.iter().map(|p| p.scaled(&minus)).collect() };
    let signed = generator.sums[result] == Some(result);
    let same = &kernel.outputs;
    let swapped: Vec<Poly> = same.iter().map(Poly::swapped).collect();
    // (ba)~ = ãb̃, so exchanged blades differ by the reverse of the result, up to sign.
    let reversed: Vec<Poly> = generator
        .kind(result)
        .fields()
        .zip(&swapped)
        .map(|(slot, poly)| {
            let sign = Involution::Reverse.sign(slot.mask.count_ones());
            poly.scaled(&Rational::from_integer(i128::from(sign)))
        })
        .collect();
    let lookups = [
        ("same", a, b, same.clone()),
        ("swapped", b, a, swapped.clone()),
        ("minus_same", a, b, negated(same)),
        ("minus_swapped", b, a, negated(&swapped)),
        ("minus_reversed", b, a, negated(&reversed)),
        ("reversed", b, a, reversed),
    ];
    for (form, first, second, polys) in lookups {
        if (form.starts_with("minus") || form == "reversed") && !signed {
            continue;
        }
        if let Some(&method) = generator.emitted.get(&(first, second, result, polys)) {
            return Some(Call {
                form,
                words: method.to_owned(),
                cost: widened_cost(generator, method, [first, second], result),
            });
        }
    }
    generator
        .emitted
        .insert((a, b, result, same.clone()), product.method());
    None
}

/// The number in the result of another product of the same operands, or the scalar product of
/// the operands exchanged.
fn hand_on_number(
    generator: &mut Generator<'_>,
    a: usize,
    b: usize,
    scalar: usize,
    kernel: &Kernel,
) -> Option<Call> {
    let same = &kernel.outputs;
    if let Some(method) = generator.emitted.get(&(a, b, scalar, same.clone())) {
        return Some(Call {
            form: "number",
            words: (*method).to_owned(),
            cost: None,
        });
    }
    // Numbers are no type of the algebra, so their bodies are noted beyond the last one.
    let number = generator.model.types.len();
    let swapped = same.iter().map(Poly::swapped).collect();
    if let Some(method) = generator.emitted.get(&(b, a, number, swapped)) {
        return Some(Call {
            form: "number_swapped",
            words: (*method).to_owned(),
            cost: None,
        });
    }
    generator.emitted.insert(
        (a, b, number, same.clone()),
        Product::ScalarProduct.method(),
    );
    None
}
