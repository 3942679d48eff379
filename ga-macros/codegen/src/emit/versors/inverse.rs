//! Which formula inverts a type: the reverse over the norm, its extension by a grade whose
//! square is a scalar, or the general algorithm.

use std::fmt::Write;

use ga_core::Product;
use ga_core::algorithm::adjugate_products;

use super::reversed;
use crate::closure;
use crate::emit::Generator;
use crate::emit::expression::{self, Names};
use crate::factor::{Cost, Kernel, TEMPORARY};
use crate::model::Type;
use crate::poly::{Element, Monomial, Poly, Variable, sum};

/// How many coefficients a type may have for the square of its norm to be looked at.
const LARGEST_SQUARED: usize = 16;

/// How a type is inverted.
enum Formula {
    /// `X X̃` is a scalar: `X⁻¹ = X̃ / (X X̃)`.
    Norm,
    /// `X X̃ = s + W` with a scalar `W²`: `X⁻¹ = X̃ (s − W) / (s² − W²)`.
    Conjugate {
        scalar: Poly,
        rest: Element,
        determinant: Poly,
    },
    /// Anything else: the Faddeev–LeVerrier algorithm on the whole algebra.
    General,
}

fn formula(generator: &Generator<'_>, a: usize) -> Formula {
    let element = &generator.general[a][0];
    let square = generator
        .tables
        .product(Product::Geometric, element, &reversed(element));
    let scalar = square.get(&0).cloned().unwrap_or_default();
    let rest: Element = square.into_iter().filter(|(mask, _)| *mask != 0).collect();
    if rest.is_empty() {
        return Formula::Norm;
    }
    // Squaring polynomials of degree two is only worth it where the closed form can hold: for
    // all even or all odd elements of five dimensions, and for sparse ones of more.
    let kind = generator.kind(a);
    if kind.parity().is_none() || kind.slots.len() > LARGEST_SQUARED {
        return Formula::General;
    }
    let rest_squared = generator.tables.product(Product::Geometric, &rest, &rest);
    if rest_squared.keys().any(|mask| *mask != 0) {
        return Formula::General;
    }
    let mut determinant = Poly::default();
    determinant.add_product(&scalar, &scalar, &ga_core::Rational::from_integer(1));
    if let Some(square) = rest_squared.get(&0) {
        determinant.add_scaled(square, &ga_core::Rational::from_integer(-1));
    }
    Formula::Conjugate {
        scalar,
        rest,
        determinant,
    }
}

/// The type of the inverse; `None` where it is not generated.
pub fn result(generator: &Generator<'_>, a: usize) -> Option<usize> {
    match formula(generator, a) {
        Formula::Norm => generator.sums[a],
        Formula::Conjugate { scalar, rest, .. } => {
            let numerator = numerator(generator, a, &scalar, &rest);
            closure::smallest(generator.model, &numerator).and_then(|i| generator.sums[i])
        }
        Formula::General => parity_type(generator, a),
    }
}

/// The type of all even, of all odd or of all elements, where they exist: inverses keep the
/// parity. A type of the user's own with the same blades comes before the standard one.
pub fn parity_type(generator: &Generator<'_>, a: usize) -> Option<usize> {
    let model = generator.model;
    if !model.is_complete() {
        return None;
    }
    let parity = generator.kind(a).parity();
    let standard = model.type_named(match parity {
        Some(true) => "Even",
        Some(false) => "Odd",
        None => "Multivector",
    })?;
    let all = model.types[standard].field_count();
    let is_whole = |kind: &Type| kind.parity() == parity && kind.field_count() == all;
    model.types.iter().position(is_whole)
}

/// `X̃ (s − W)`.
fn numerator(generator: &Generator<'_>, a: usize, scalar: &Poly, rest: &Element) -> Element {
    let conjugate = sum(&Element::from([(0, scalar.clone())]), rest, -1);
    generator.tables.product(
        Product::Geometric,
        &reversed(&generator.general[a][0]),
        &conjugate,
    )
}

/// What an inverse costs at most beyond one division; `None` where there is none.
pub fn cost(generator: &Generator<'_>, a: usize) -> Option<Cost> {
    let fields = generator.kind(result(generator, a)?).field_count();
    let polynomials = match formula(generator, a) {
        Formula::Norm => vec![super::norm_polynomial(generator, a)],
        Formula::Conjugate { scalar, rest, .. } => {
            let squares: Vec<Poly> = rest.into_values().chain([scalar]).collect();
            // The determinant squares each of them, the numerator multiplies each field by each.
            let steps = squares.len() * (1 + generator.kind(a).field_count());
            let whole = Kernel::expanded(squares).cost() + Cost::multiplying(steps + fields);
            return Some(Cost {
                additions: whole.additions + steps,
                ..whole
            });
        }
        Formula::General => return Some(general_cost(generator)? + Cost::multiplying(fields)),
    };
    Some(Kernel::expanded(polynomials).cost() + Cost::multiplying(fields))
}

/// Emits the inverse of a type.
pub fn inverse(generator: &mut Generator<'_>, a: usize) {
    let Some(result) = result(generator, a) else {
        return;
    };
    let (name, output) = (generator.name(a), generator.name(result));
    match formula(generator, a) {
        Formula::Norm => {
            let doc = format!(
                " The reverse; over the squared norm it is the inverse, `X⁻¹ = X̃ / (X X̃)`.{}",
                expression::cost_sentence(cost(generator, a))
            );
            let _ = writeln!(
                generator.source,
                "algebra::inverse! {{ {name} => {output} {doc:?} }}"
            );
        }
        Formula::General => {
            let all = 1_usize << generator.model.dimension();
            let doc = general_documentation(generator);
            let _ = writeln!(
                generator.source,
                "algebra::general_inverse! {{ {name} => {output} in Multivector {all} {doc:?} }}"
            );
        }
        Formula::Conjugate {
            scalar,
            rest,
            determinant,
        } => {
            let text = conjugate_inverse(generator, a, result, &scalar, &rest, &determinant);
            generator.source.push_str(&text);
        }
    }
}

/// What the Faddeev–LeVerrier algorithm does, and what it costs.
fn general_documentation(generator: &Generator<'_>) -> String {
    let steps = general_steps(generator);
    format!(
        " By the Faddeev–LeVerrier recursion, `A⁻¹ = P / d`: from `U = A`, for `k = 1 … {steps}`, \
         `P = U − ({}/k) ⟨U⟩` and `U = A P`; then `d = ⟨U⟩`.{}",
        steps + 1,
        expression::cost_sentence(general_cost(generator))
    )
}

/// How many products the Faddeev–LeVerrier algorithm takes.
fn general_steps(generator: &Generator<'_>) -> usize {
    adjugate_products(1 << generator.model.dimension())
}

fn general_cost(generator: &Generator<'_>) -> Option<Cost> {
    let whole = generator.model.type_named("Multivector")?;
    let steps = general_steps(generator);
    let product = super::product_cost(generator, whole, whole)?;
    Some(Cost {
        fused: steps * (product.fused + 1),
        multiplications: steps * (product.multiplications + 1),
        additions: steps * (product.additions + 1),
    })
}

fn conjugate_inverse(
    generator: &Generator<'_>,
    a: usize,
    result: usize,
    scalar: &Poly,
    rest: &Element,
    determinant: &Poly,
) -> String {
    // The norm and its conjugate part are named once; the numerator is bilinear in them.
    let temporary = |slot: usize| {
        let variable = Variable {
            operand: TEMPORARY,
            slot: slot as u16,
        };
        Poly::term(Monomial::of(variable), ga_core::Rational::from_integer(1))
    };
    let mut temporaries = vec![scalar.clone()];
    let mut named_rest = Element::new();
    for (mask, poly) in rest {
        named_rest.insert(*mask, temporary(temporaries.len()));
        temporaries.push(poly.clone());
    }
    let rest_squared = generator
        .tables
        .product(Product::Geometric, &named_rest, &named_rest);
    let mut named_determinant = Poly::default();
    let one = ga_core::Rational::from_integer(1);
    named_determinant.add_product(&temporary(0), &temporary(0), &one);
    if let Some(square) = rest_squared.get(&0) {
        named_determinant.add_scaled(square, &ga_core::Rational::from_integer(-1));
    }
    // Where cancellation leaves nothing of the determinant, nothing is invertible.
    if determinant.is_zero() {
        named_determinant = Poly::default();
    }
    let conjugate = sum(&Element::from([(0, temporary(0))]), &named_rest, -1);
    let full = numerator(generator, a, scalar, rest);
    let named = generator.tables.product_onto(
        Product::Geometric,
        &reversed(&generator.general[a][0]),
        &conjugate,
        |mask| full.contains_key(&mask),
    );
    let names = Names::new(generator.kind(a), None);
    let kernel = Kernel {
        temporaries: temporaries.clone(),
        outputs: generator.onto_fields(result, &named),
        form: "conjugate".into(),
    }
    .factored();
    let determinant_kernel = Kernel {
        temporaries,
        outputs: vec![named_determinant],
        form: "conjugate".into(),
    }
    .without_unused()
    .factored();
    let doc = "The inverse `X̃ (s − W) / (s² − W²)` with `X X̃ = s + W`, by its numerator.";
    let documentation =
        expression::documentation(doc, &kernel, Some(generator.kind(result)), &names);
    let numerator = expression::body(&kernel, Some(generator.kind(result)), &names);
    let doc = "The determinant `s² − W²` with `X X̃ = s + W`.";
    let determinant_documentation =
        expression::documentation(doc, &determinant_kernel, None, &names);
    let determinant = expression::body(&determinant_kernel, None, &names);
    let (name, output) = (generator.name(a), generator.name(result));
    format!(
        "impl<T: Field> Inverse for {name}<T> {{ type Output = {output}<T>; type Number = T; \
         {} #[inline] fn determinant(self) -> T {{ algebra::kernel! {{ {determinant} }} }} {} #[inline] \
         fn adjugate(self) -> {output}<T> {{ algebra::kernel! {{ {numerator} }} }} \
         #[doc = \" The adjugate times a number, one multiplication a coefficient.\"] \
         #[inline] fn scale(adjugate: {output}<T>, factor: T) -> {output}<T> {{ adjugate * factor }} }}\n",
        expression::doc(&determinant_documentation),
        expression::doc(&documentation)
    )
}
