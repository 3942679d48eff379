//! Which functions are computed by series and iterations, on the smallest complete type, and how
//! many of its products they take.

use std::fmt::Write;

use ga_core::algorithm::{
    MOST_HALVINGS, MOST_ROOTS, MOST_STEPS, MOST_TERMS, ORTHONORMAL_TERMS, logarithm_products,
    square_root_products, step_products,
};
use ga_core::{Product, Rational};

use crate::closure;
use crate::emit::Generator;
use crate::emit::expression;
use crate::emit::versors::inverse::parity_type;
use crate::emit::versors::product_cost;
use crate::poly::Element;

/// The exponential as a power series.
pub fn series_exponential(generator: &mut Generator<'_>, a: usize) {
    let Some(result) = parity_type(generator, a) else {
        return;
    };
    // Powers of an odd element are odd and even, so only even elements stay in `Even`.
    let odd = generator.kind(a).parity() == Some(false);
    let whole = generator.model.type_named("Multivector").filter(|_| odd);
    let result = whole.unwrap_or(result);
    if !generator.model.products.contains(&Product::Geometric) {
        return;
    }
    let terms = if blades_multiply_to_blades(generator) {
        ORTHONORMAL_TERMS
    } else {
        MOST_TERMS
    };
    let fields = generator.kind(result).field_count();
    let (name, output) = (generator.name(a), generator.name(result));
    let doc = format!(
        " The exponential by scaling and squaring, `exp X = (1 + Y + Y²/2! + …)^(2ᵏ)` with \
         `Y = X/2ᵏ`: `k` halvings until the coefficients add up to no more than 4, so many terms \
         of the series that the next would be lost in rounding, `k` squarings. Cost: for a finite \
         `X` at most {terms} + k products of two `{output}`{}, and beside each at most {} \
         multiplications, {} additions and a division. `k` is at most {MOST_HALVINGS}.",
        of_products(generator, result),
        fields + 1,
        3 * fields,
    );
    let _ = writeln!(
        generator.source,
        "algebra::series_exponential! {{ {name} => {output} {doc:?} }}"
    );
}

/// Whether the product of two basis blades is a basis blade, its negative or zero.
fn blades_multiply_to_blades(generator: &Generator<'_>) -> bool {
    let metric = &generator.model.metric;
    let units = [-1, 0, 1].map(Rational::from_integer);
    metric.is_diagonal() && (0..metric.dimension()).all(|i| units.contains(&metric.gram(i, i)))
}

/// What each product of two elements of a type costs.
fn of_products(generator: &Generator<'_>, a: usize) -> String {
    product_cost(generator, a, a).map_or_else(String::new, |cost| {
        format!(", each of at most {}", expression::counts(cost))
    })
}

/// `log` and `sqrt` of even elements without closed forms.
pub fn iterated_functions(generator: &mut Generator<'_>, a: usize) {
    let even = generator.kind(a).parity() == Some(true);
    let Some(whole) = parity_type(generator, a).filter(|_| even) else {
        return;
    };
    let bivectors: Element = generator.general[whole][0]
        .iter()
        .filter(|(mask, _)| mask.count_ones() == 2)
        .map(|(mask, poly)| (*mask, poly.clone()))
        .collect();
    let Some(bivector) = closure::smallest(generator.model, &bivectors) else {
        return;
    };
    if !generator.model.products.contains(&Product::Geometric) {
        return;
    }
    let each = of_products(generator, whole);
    let fields = generator.kind(whole).field_count();
    let (name, whole) = (generator.name(a), generator.name(whole));
    let bivector = generator.name(bivector);
    let log = format!(
        " The principal logarithm of the versor over its norm, by inverse scaling and squaring: \
         `log R = 2ᵏ arsinh((S − S̃)/2)` with `S = R^(1/2ᵏ)`, after `k` square roots so near 1 \
         that the coefficients of `S − 1` add up to no more than ½, then a power series. `None` \
         unless its turns add up to less than π, and for what is no versor. Cost: at most {} \
         products of two `{whole}`{each}: `k` is at most {MOST_ROOTS}, and a root takes at most \
         {MOST_STEPS} steps of up to {} products.",
        logarithm_products(fields),
        step_products(fields),
    );
    let sqrt = format!(
        " The principal square root `√|R| exp(½ log R)`. `None` as for the logarithm. Cost: at \
         most {} products of two `{whole}`, those of the logarithm and of an exponential.",
        square_root_products(fields),
    );
    let _ = writeln!(
        generator.source,
        "algebra::iterated_functions! {{ {name} => {whole} {bivector} {log:?} {sqrt:?} }}"
    );
}
