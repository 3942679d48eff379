//! Versor application: `V x̂ Ṽ` restricted to the grades of `x`, by the cheapest form known.

mod kernels;

use std::fmt::Write;

use ga_core::Product;

use self::kernels::{cheaper, divided_by_norm, drop_unused, moving, named, onto};
use super::inverse::parity_type;
use super::reversed;
use crate::closure;
use crate::emit::Generator;
use crate::emit::expression::{self, Names};
use crate::factor::{Cost, Kernel};
use crate::ledger::Entry;
use crate::model::Type;
use crate::poly::{Element, Monomial, Poly, Variable, graded_signs, sum};

/// How many terms a sandwich may have to be unrolled where the type looks like a versor.
const VERSOR_LIMIT: usize = 200;
/// How many terms it may have where the type could be anything, in small algebras.
const ELEMENT_LIMIT: usize = 60;
/// Up to how many types an algebra is small.
const SMALL_ALGEBRA: usize = 12;
/// How many terms a sandwich may have before collection for its polynomials to be looked at.
const LARGEST_POLYNOMIAL: usize = 20_000;

/// What is known of applying one type to another.
struct Application {
    /// The type of `V x̂ Ṽ`.
    sandwich: usize,
    /// The body of the sandwich, where it is short enough to be unrolled.
    sandwich_kernel: Option<Kernel>,
    /// The type of `V x̂ V⁻¹`, where fixed coefficients may be kept.
    applied: usize,
    /// The body of the application, where it is not the sandwich itself.
    applied_kernel: Option<Kernel>,
}

/// Emits sandwiches and applications of every type of one parity on every type.
pub fn applications(generator: &mut Generator<'_>) {
    for v in 0..generator.model.types.len() {
        if let Some(even) = generator.kind(v).parity() {
            applications_of(generator, v, even);
        }
    }
}

fn applications_of(generator: &mut Generator<'_>, v: usize, even: bool) {
    // A type of null elements only, such as a direction, has sandwiches but is no versor.
    let norm = super::norm_polynomial(generator, v);
    let invertible = !norm.is_zero();
    let norm_cost = Kernel::expanded(vec![norm]).cost();
    let unit = is_unit(generator, v);
    let summary = match unit {
        true => "The unit versor applied to `x`, `V x̂ Ṽ` (2.28).",
        false => "The versor applied to `x`, `V x̂ V⁻¹` (2.28): the sandwich over the norm.",
    };
    let mut composed: Vec<String> = Vec::new();
    let mut applied: Vec<String> = Vec::new();
    for x in 0..generator.model.types.len() {
        let Some(application) = application(generator, v, x, even) else {
            continue;
        };
        let (operand, result) = (generator.name(x), generator.name(application.sandwich));
        let sandwich_cost = match &application.sandwich_kernel {
            Some(kernel) => Some(kernel.cost()),
            None => composed_cost(generator, v, x, application.sandwich),
        };
        match &application.sandwich_kernel {
            Some(kernel) => {
                let doc = match unit {
                    true => "The unit versor applied to `x`, `V x̂ Ṽ` (2.28).",
                    false => "The sandwich `V x̂ Ṽ`, which is `V x̂ V⁻¹` (2.28) times `V Ṽ`.",
                };
                let names = ["Sandwich", "sandwich"];
                emit_kernel(generator, [v, x, application.sandwich], names, kernel, doc);
            }
            None => {
                let doc = format!(
                    " `V x̂ Ṽ` as two products, restricted to the grades of `x`.{}",
                    expression::cost_sentence(sandwich_cost)
                );
                composed.push(format!("{operand} => {result} {doc:?}"));
            }
        }
        let divided = !unit && generator.kind(application.applied).has_fixed();
        match &application.applied_kernel {
            _ if !invertible => {}
            Some(kernel) => {
                let doc = "The versor applied to `x`, `V x̂ V⁻¹` (2.28).";
                let names = ["Apply", "apply"];
                emit_kernel(generator, [v, x, application.applied], names, kernel, doc);
            }
            None if application.applied == application.sandwich && !divided => {
                let fields = generator.kind(application.applied).field_count();
                let cost = match unit {
                    true => sandwich_cost,
                    false => sandwich_cost.map(|cost| cost + norm_cost + Cost::multiplying(fields)),
                };
                let doc = format!(" {summary}{}", expression::cost_sentence(cost));
                applied.push(format!("{operand} {doc:?}"));
            }
            None => emit_kept(generator, v, x, &application),
        }
    }
    let name = generator.name(v);
    let parity = if even { "even" } else { "odd" };
    let norm = if unit { "unit" } else { "divided" };
    if !composed.is_empty() {
        let list = composed.join(", ");
        let _ = writeln!(
            generator.source,
            "algebra::composed_sandwich! {{ {name} {parity}: {list} }}"
        );
    }
    if !applied.is_empty() {
        let list = applied.join(", ");
        let _ = writeln!(
            generator.source,
            "algebra::application! {{ {name} {norm}: {list} }}"
        );
    }
}

/// What a sandwich of two products costs at most; `None` where that is too long to find out.
fn composed_cost(generator: &Generator<'_>, v: usize, x: usize, result: usize) -> Option<Cost> {
    let (versor, operand) = (&generator.general[v], &generator.general[x][1]);
    if versor[0].len().pow(2) * operand.len() > LARGEST_POLYNOMIAL {
        return None;
    }
    let product = |a: &Element, b: &Element| generator.tables.product(Product::Geometric, a, b);
    let first = product(&versor[0], operand);
    let between = closure::smallest(generator.model, &first)?;
    let second = product(&generator.general[between][0], &reversed(&versor[1]));
    let first = Kernel::expanded(generator.onto_fields(between, &first));
    let second = Kernel::expanded(generator.onto_fields(result, &second));
    Some(first.cost() + second.cost())
}

/// Whether `V Ṽ = 1` by declaration or by the fixed coefficients.
fn is_unit(generator: &Generator<'_>, v: usize) -> bool {
    let versor = &generator.general[v][0];
    if generator.kind(v).unit || !generator.kind(v).has_fixed() {
        return generator.kind(v).unit;
    }
    let one = ga_core::Rational::from_integer(1);
    let square = generator
        .tables
        .product(Product::Geometric, versor, &reversed(versor));
    square.len() == 1 && square.get(&0).and_then(Poly::as_constant) == Some(one)
}

/// Whether unrolling is worth its tokens: declared versors, scalar-plus-blade types, vectors.
fn looks_like_versor(kind: &Type) -> bool {
    let rotor_like = kind.slot(0).is_some() && kind.field_count() > 1;
    kind.unit || rotor_like || kind.grades() == 0b10
}

fn application(generator: &Generator<'_>, v: usize, x: usize, even: bool) -> Option<Application> {
    let model = generator.model;
    let kind = generator.kind(x);
    let grades = kind.grades();
    let wanted = |mask: u32| grades >> mask.count_ones() & 1 == 1;
    let unit = is_unit(generator, v);
    // Large types in high dimensions would take minutes of polynomial arithmetic for a body
    // that is composed anyway; there the operand's own grades are the result.
    let size = generator.kind(v).slots.len().pow(2) * kind.slots.len();
    if size > LARGEST_POLYNOMIAL {
        let by_grade = closure_of_grades(generator, x)?;
        return Some(Application {
            sandwich: by_grade,
            sandwich_kernel: None,
            applied: by_grade,
            applied_kernel: None,
        });
    }
    let versor = &generator.general[v][0];
    let operand = &generator.general[x][1];
    let reflected = graded_signs(operand, |grade| if even || grade % 2 == 0 { 1 } else { -1 });
    let product = |a: &Element, b: &Element| generator.tables.product(Product::Geometric, a, b);
    let restricted = |a: &Element, b: &Element| {
        generator
            .tables
            .product_onto(Product::Geometric, a, b, wanted)
    };
    let first = product(versor, &reflected);
    let difference = sum(&first, &product(operand, versor), -1);
    let back = reversed(versor);
    let whole = restricted(&first, &back);
    let moved = sum(operand, &restricted(&difference, &back), 1);
    let pick = |element: &Element| {
        let same = closure::holds(kind, element);
        same.then_some(x)
            .or_else(|| closure::smallest(model, element))
    };
    // Whether the operand's fixed coefficients stay, is seen from x + (V x̂ − x V) V⁻¹ alone.
    let keeps = kind.has_fixed() && closure::holds(kind, &moved);
    let whole_type = pick(&whole)?;
    let applied = match (keeps, unit) {
        (true, _) => x,
        (false, true) => whole_type,
        (false, false) => generator.sums[whole_type]?,
    };
    let limit = unroll_limit(generator, v, applied);
    let short = |kernel: Kernel| Some(kernel).filter(|kernel| kernel.terms() <= limit);
    if unit {
        let kernel = moving(generator, applied, &difference, &back, operand, &whole);
        let expanded = Kernel::expanded(generator.onto_fields(applied, &moved));
        return Some(Application {
            sandwich: applied,
            sandwich_kernel: short(cheaper(expanded, kernel)),
            applied,
            applied_kernel: None,
        });
    }
    // V⁻¹ = Ṽ / (V Ṽ): the reverse is divided once, and the rest is as for a unit versor.
    let applied_kernel = if looks_like_versor(generator.kind(v)) {
        let (divided, temporaries) = divided_by_norm(&back, difference.len());
        let mut kernel = moving(generator, applied, &difference, &divided, operand, &whole);
        kernel.divisor = Some(super::norm_polynomial(generator, v));
        kernel.temporaries.extend(temporaries);
        short(drop_unused(kernel))
    } else {
        None
    };
    // In large algebras one unrolled body per pair has to do.
    let small = model.types.len() <= SMALL_ALGEBRA;
    let sandwich_kernel = if applied_kernel.is_none() || small {
        let (named, temporaries) = named(&first, 0);
        let second = onto(generator, whole_type, &named, &back, &whole);
        let steps = Kernel {
            divisor: None,
            temporaries,
            outputs: generator.onto_fields(whole_type, &second),
            form: "(V x) Ṽ",
        };
        let expanded = Kernel::expanded(generator.onto_fields(whole_type, &whole));
        short(cheaper(expanded, drop_unused(steps)))
    } else {
        None
    };
    Some(Application {
        sandwich: whole_type,
        sandwich_kernel,
        applied,
        applied_kernel,
    })
}

/// How many terms the body may have; in large algebras only versors are unrolled, and not where
/// the result is of a type that holds everything of a parity.
fn unroll_limit(generator: &Generator<'_>, v: usize, result: usize) -> usize {
    let small = generator.model.types.len() <= SMALL_ALGEBRA;
    let everything = parity_type(generator, result) == Some(result);
    if looks_like_versor(generator.kind(v)) && (small || !everything) {
        VERSOR_LIMIT
    } else if small {
        ELEMENT_LIMIT
    } else {
        0
    }
}

/// The smallest type with all blades of the operand's grades.
fn closure_of_grades(generator: &Generator<'_>, x: usize) -> Option<usize> {
    let grades = generator.kind(x).grades();
    let marker = Poly::term(
        Monomial::of(Variable {
            operand: 0,
            slot: 0,
        }),
        ga_core::Rational::from_integer(1),
    );
    let element: Element = (0..1_u32 << generator.model.dimension())
        .filter(|mask| grades >> mask.count_ones() & 1 == 1)
        .map(|mask| (mask, marker.clone()))
        .collect();
    closure::smallest(generator.model, &element)
}

fn emit_kernel(
    generator: &mut Generator<'_>,
    [v, x, result]: [usize; 3],
    [trait_name, method]: [&str; 2],
    kernel: &Kernel,
    doc: &str,
) {
    generator.check(kernel);
    let names = Names::new(generator.kind(v), Some(("x", generator.kind(x))));
    let kind = generator.kind(result);
    let documentation = expression::documentation(doc, kernel, Some(kind), &names);
    let body = expression::body(kernel, Some(kind), &names);
    let (versor, operand, output) = (generator.name(v), generator.name(x), generator.name(result));
    let ring = expression::is_integral(kernel) && kernel.divisor.is_none();
    let bound = if ring { "Number" } else { "Field" };
    let fields = kind.field_count();
    let _ = writeln!(
        generator.source,
        "impl<T: {bound}> {trait_name}<{operand}<T>> for {versor}<T> {{ type Output = {output}<T>; \
         {} #[inline] fn {method}(self, x: {operand}<T>) -> {output}<T> {{ {body} }} }}",
        expression::doc(&documentation)
    );
    generator.record(Entry {
        function: format!("{versor}.{method}({operand})"),
        result: output,
        cost: Some(kernel.cost()),
        fields,
        form: kernel.form.to_owned(),
    });
}

/// An application whose result is not simply the sandwich over the norm: `V x̂ V⁻¹` keeps fixed
/// coefficients that `V x̂ Ṽ` does not, or the other way round.
fn emit_kept(generator: &mut Generator<'_>, v: usize, x: usize, sandwich: &Application) {
    let (versor, operand) = (generator.name(v), generator.name(x));
    let applied = sandwich.applied;
    let image = generator.kind(sandwich.sandwich);
    let names = Names::new(image, None);
    let fields: Vec<String> = generator
        .kind(applied)
        .fields()
        .zip(generator.onto_fields(applied, &generator.general[sandwich.sandwich][0]))
        .map(|(slot, poly)| {
            let value = match poly.is_zero() {
                true => "T::ZERO".to_owned(),
                false => format!(
                    "({}) * f",
                    expression::code(&poly, &names).replace("self.", "y.")
                ),
            };
            format!("{}: {value}", slot.field)
        })
        .collect();
    let output = generator.name(applied);
    let _ = writeln!(
        generator.source,
        "impl<T: Field> Apply<{operand}<T>> for {versor}<T> {{ type Output = {output}<T>; \
         #[doc = \" The versor applied to `x`, `V x̂ V⁻¹` (2.28), which keeps the fixed \
         coefficients.\"] #[inline] fn apply(self, x: {operand}<T>) -> {output}<T> {{ \
         let y = self.sandwich(x); let f = T::ONE / self.norm_squared(); \
         {output} {{ {} }} }} }}",
        fields.join(", ")
    );
}
