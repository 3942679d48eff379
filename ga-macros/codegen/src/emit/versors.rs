//! Versors: norms, inverses, sandwiches and application, exponentials, logarithms and roots.

mod application;
mod exponential;
mod inverse;

use std::fmt::Write;

use ga_core::{Involution, Product};

pub use inverse::parity_type;

use super::Generator;
use super::expression::{self, Names};
use super::products::{loop_from, widened_cost};
use super::unrolled;
use crate::closure;
use crate::factor::{Cost, Kernel};
use crate::ledger::Entry;
use crate::poly::{Element, Poly, graded_signs};

/// How many pairs of blades a product may have for its polynomials to be counted out.
const LARGEST_PRODUCT: usize = 1_024;

/// Emits everything that treats a type as a versor.
pub fn versors(generator: &mut Generator<'_>) {
    for a in 0..generator.model.types.len() {
        norm(generator, a);
        inverse::inverse(generator, a);
        exponential::exponential(generator, a);
    }
    if generator.model.apply {
        application::applications(generator);
    }
    if generator.model.products.contains(&Product::Geometric) {
        quotients(generator);
    }
}

/// The reverse of the general element of a type.
fn reversed(element: &Element) -> Element {
    graded_signs(element, |grade| Involution::Reverse.sign(grade))
}

/// `⟨X X̃⟩` as a polynomial.
fn norm_polynomial(generator: &Generator<'_>, a: usize) -> Poly {
    let element = &generator.general[a][0];
    let square = generator
        .tables
        .product(Product::ScalarProduct, element, &reversed(element));
    square.get(&0).cloned().unwrap_or_default()
}

/// `⟨X X̃⟩`, with its sign (2.21 as corrected).
fn norm(generator: &mut Generator<'_>, a: usize) {
    let poly = norm_polynomial(generator, a);
    let names = Names::new(generator.kind(a), None);
    let kernel = Kernel::expanded(vec![poly]).factored();
    generator.check(&kernel);
    let bound = unrolled::bound(&kernel);
    let body = expression::body(&kernel, None, &names);
    let doc = "The squared norm `⟨X X̃⟩`, with its sign.";
    let documentation = expression::documentation(doc, &kernel, None, &names);
    let name = generator.name(a);
    let _ = writeln!(
        generator.source,
        "impl<T: {bound}> NormSquared for {name}<T> {{ type Output = T; {} #[inline] \
         fn norm_squared(self) -> T {{ algebra::kernel! {{ {body} }} }} }}",
        expression::doc(&documentation)
    );
    let entry = Entry {
        function: format!("{name}.norm_squared()"),
        result: "T".to_owned(),
        cost: Some(kernel.cost()),
        fields: 1,
        form: kernel.form.to_string(),
    };
    generator.record(entry);
}

/// `A / B = A B⁻¹` for every pair whose product exists.
fn quotients(generator: &mut Generator<'_>) {
    let count = generator.model.types.len();
    let inverses: Vec<Option<usize>> = (0..count).map(|b| inverse::result(generator, b)).collect();
    let costs: Vec<Option<Cost>> = (0..count).map(|b| inverse::cost(generator, b)).collect();
    let mut source = String::new();
    for a in 0..count {
        let exists = |inverse: usize| {
            // Where the types of both parities exist, every product has a type.
            generator.model.is_complete() || {
                let (left, right) = (&generator.general[a][0], &generator.general[inverse][1]);
                let product = generator.tables.product(Product::Geometric, left, right);
                closure::smallest(generator.model, &product).is_some()
            }
        };
        let divisors: Vec<String> = (0..count)
            .filter_map(|b| {
                let inverse = inverses[b].filter(|&inverse| exists(inverse))?;
                let product = product_cost(generator, a, inverse);
                let cost = product
                    .zip(costs[b])
                    .map(|(product, inverse)| product + inverse);
                let doc = format!(
                    " The quotient `a b⁻¹`, the geometric product with the inverse.{} A division \
                     besides.",
                    expression::cost_sentence(cost)
                );
                Some(format!("{} {doc:?}", generator.name(b)))
            })
            .collect();
        if !divisors.is_empty() {
            let name = generator.name(a);
            let _ = writeln!(
                source,
                "algebra::quotients! {{ {name}: {} }}",
                divisors.join(", ")
            );
        }
    }
    generator.source.push_str(&source);
}

/// What a geometric product costs at most; `None` where no type holds it.
fn product_cost(generator: &Generator<'_>, a: usize, b: usize) -> Option<Cost> {
    geometric_product(generator, a, b).map(|(_, cost)| cost)
}

/// The type of a geometric product, and what it costs at most, whether it is unrolled, a loop or
/// that of wider operands; `None` where no type holds it.
fn geometric_product(generator: &Generator<'_>, a: usize, b: usize) -> Option<(usize, Cost)> {
    let (left, right) = (&generator.general[a][0], &generator.general[b][1]);
    if left.len() * right.len() > LARGEST_PRODUCT.min(loop_from(generator.model.dimension())) {
        return looped_product(generator, left, right);
    }
    let product = generator.tables.product(Product::Geometric, left, right);
    let result = closure::smallest(generator.model, &product)?;
    let cost = match widened_cost(generator, Product::Geometric.method(), [a, b], result) {
        Some(cost) => cost,
        None => Kernel::expanded(generator.onto_fields(result, &product)).cost(),
    };
    Some((result, cost))
}

/// The same for a loop: a multiplication and an addition for each term, and a multiplication for
/// each that has a factor from the metric.
fn looped_product(
    generator: &Generator<'_>,
    left: &Element,
    right: &Element,
) -> Option<(usize, Cost)> {
    let masks = |element: &Element| element.keys().copied().collect::<Vec<u32>>();
    let tables = &generator.tables;
    let reach = tables.reach(Product::Geometric, &masks(left), &masks(right));
    // Any variable polynomial marks a coefficient as free.
    let any = left
        .values()
        .chain(right.values())
        .find(|poly| poly.as_constant().is_none())?;
    let blades = reach.blades.into_iter().map(|mask| (mask, any.clone()));
    let result = closure::smallest(generator.model, &blades.collect())?;
    let cost = Cost {
        fused: reach.terms + reach.factors,
        multiplications: reach.terms + reach.factors,
        additions: reach.terms,
    };
    Some((result, cost))
}
