//! Versor application: `V x̂ Ṽ` restricted to the grades of `x`, by the cheapest form known.

use std::collections::BTreeMap;
use std::fmt::Write;

use ga_core::Product;

use super::inverse::parity_type;
use super::reversed;
use crate::closure;
use crate::emit::Generator;
use crate::emit::expression::{self, Names};
use crate::factor::{Kernel, TEMPORARY};
use crate::ledger::Entry;
use crate::model::Type;
use crate::poly::{Element, Monomial, Poly, Variable, graded_signs, sum};

/// How many terms a sandwich may have to be unrolled where the type looks like a versor.
const VERSOR_LIMIT: usize = 200;
/// How many terms it may have where the type could be anything, in small algebras.
const ELEMENT_LIMIT: usize = 60;
/// Up to how many types an algebra is small.
const SMALL_ALGEBRA: usize = 12;

/// What is known of applying one type to another.
struct Sandwich {
    /// The type of `V x̂ Ṽ`.
    result: usize,
    /// The type of `V x̂ V⁻¹`, where fixed coefficients may be kept.
    applied: usize,
    /// The body, where it is short enough to be unrolled.
    kernel: Option<Kernel>,
}

/// Emits sandwiches and applications of every type of one parity on every type.
pub fn applications(generator: &mut Generator<'_>) {
    let count = generator.model.types.len();
    for v in 0..count {
        let Some(even) = generator.kind(v).parity() else {
            continue;
        };
        // A type of null elements only, such as a direction, has sandwiches but is no versor.
        let norm = super::norm_polynomial(generator, v);
        let invertible = !norm.is_zero();
        let unit = is_unit(generator, v);
        let mut composed: Vec<String> = Vec::new();
        let mut applied: Vec<String> = Vec::new();
        for x in 0..count {
            let Some(sandwich) = sandwich(generator, v, x, even) else {
                continue;
            };
            let (operand, result) = (generator.name(x), generator.name(sandwich.result));
            match &sandwich.kernel {
                Some(kernel) => emit_kernel(generator, v, x, sandwich.result, kernel),
                None => composed.push(format!("{operand} => {result}")),
            }
            if !invertible {
                continue;
            }
            let divided = !unit && generator.kind(sandwich.applied).has_fixed();
            if sandwich.applied == sandwich.result && !divided {
                applied.push(operand);
            } else {
                emit_kept(generator, v, x, &sandwich);
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

fn sandwich(generator: &Generator<'_>, v: usize, x: usize, even: bool) -> Option<Sandwich> {
    let model = generator.model;
    let kind = generator.kind(x);
    let grades = kind.grades();
    let wanted = |mask: u32| grades >> mask.count_ones() & 1 == 1;
    let unit = is_unit(generator, v);
    // Large types in high dimensions would take minutes of polynomial arithmetic for a body
    // that is composed anyway; there the operand's own grades are the result.
    let size = generator.kind(v).slots.len().pow(2) * kind.slots.len();
    if size > 20_000 {
        let by_grade = closure_of_grades(generator, x)?;
        return Some(Sandwich {
            result: by_grade,
            applied: by_grade,
            kernel: None,
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
    let result = if unit { applied } else { whole_type };
    let (first, start) = if unit {
        (&difference, Some(operand))
    } else {
        (&first, None)
    };
    let final_element = if unit { &moved } else { &whole };
    let kernel = cheapest(generator, result, first, &back, start, final_element);
    let limit = unroll_limit(generator, v, x);
    let kernel = Some(kernel).filter(|kernel| kernel.terms() <= limit);
    Some(Sandwich {
        result,
        applied,
        kernel,
    })
}

/// How many terms the body may have; in large algebras only versors are unrolled, and not on
/// the types that hold everything of a parity.
fn unroll_limit(generator: &Generator<'_>, v: usize, x: usize) -> usize {
    let small = generator.model.types.len() <= SMALL_ALGEBRA;
    let everything = parity_type(generator, x) == Some(x);
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

/// The cheaper of one expanded polynomial per field, and two steps with named intermediates.
fn cheapest(
    generator: &Generator<'_>,
    result: usize,
    first: &Element,
    back: &Element,
    start: Option<&Element>,
    whole: &Element,
) -> Kernel {
    let expanded = Kernel::expanded(generator.onto_fields(result, whole));
    let mut named = Element::new();
    let mut masks = BTreeMap::new();
    for (number, mask) in first.keys().enumerate() {
        let variable = Variable {
            operand: TEMPORARY,
            slot: number as u16,
        };
        let one = ga_core::Rational::from_integer(1);
        named.insert(*mask, Poly::term(Monomial::of(variable), one));
        masks.insert(number, *mask);
    }
    let kind = generator.kind(result);
    let second = generator
        .tables
        .product_onto(Product::Geometric, &named, back, |mask| {
            kind.slot(mask).is_some_and(|slot| slot.fixed.is_none()) && whole.contains_key(&mask)
        });
    let second = match start {
        Some(operand) => sum(operand, &second, 1),
        None => second,
    };
    let form = if start.is_some() {
        "x + (V x − x V) Ṽ"
    } else {
        "(V x) Ṽ"
    };
    let two_steps = Kernel {
        temporaries: masks.values().map(|mask| first[mask].clone()).collect(),
        outputs: generator.onto_fields(result, &second),
        form,
    };
    let two_steps = drop_unused(two_steps);
    if expanded.cost() <= two_steps.cost() {
        expanded
    } else {
        two_steps
    }
}

/// Removes temporaries that no output uses and numbers the others anew.
fn drop_unused(kernel: Kernel) -> Kernel {
    let used = |number: usize| {
        kernel
            .outputs
            .iter()
            .flat_map(Poly::terms)
            .any(|(monomial, _)| {
                monomial
                    .variables()
                    .any(|v| v.operand == TEMPORARY && usize::from(v.slot) == number)
            })
    };
    let kept: Vec<usize> = (0..kernel.temporaries.len()).filter(|n| used(*n)).collect();
    let outputs = kernel.outputs.iter().map(|poly| {
        poly.renamed(
            |v| match kept.iter().position(|n| *n == usize::from(v.slot)) {
                Some(new) if v.operand == TEMPORARY => Variable {
                    slot: new as u16,
                    ..v
                },
                _ => v,
            },
        )
    });
    Kernel {
        outputs: outputs.collect(),
        temporaries: kept
            .iter()
            .map(|n| kernel.temporaries[*n].clone())
            .collect(),
        form: kernel.form,
    }
}

fn emit_kernel(generator: &mut Generator<'_>, v: usize, x: usize, result: usize, kernel: &Kernel) {
    generator.check(kernel);
    let names = Names::new(generator.kind(v), Some(("x", generator.kind(x))));
    let doc = if is_unit(generator, v) {
        "The unit versor applied to `x`, `V x̂ Ṽ` (2.28)."
    } else {
        "The sandwich `V x̂ Ṽ`, which is `V x̂ V⁻¹` (2.28) times `V Ṽ`."
    };
    let kind = generator.kind(result);
    let documentation = expression::documentation(doc, kernel, Some(kind), &names);
    let body = expression::body(kernel, Some(kind), &names);
    let (versor, operand, output) = (generator.name(v), generator.name(x), generator.name(result));
    let bound = if expression::is_integral(kernel) {
        "Number"
    } else {
        "Field"
    };
    let fields = kind.field_count();
    let _ = writeln!(
        generator.source,
        "impl<T: {bound}> Sandwich<{operand}<T>> for {versor}<T> {{ type Output = {output}<T>; {} \
         #[inline] fn sandwich(self, x: {operand}<T>) -> {output}<T> {{ {body} }} }}",
        expression::doc(&documentation)
    );
    generator.record(Entry {
        function: format!("{versor}.sandwich({operand})"),
        result: output,
        cost: Some(kernel.cost()),
        fields,
        form: kernel.form.to_owned(),
    });
}

/// An application whose result is not simply the sandwich over the norm: `V x̂ V⁻¹` keeps fixed
/// coefficients that `V x̂ Ṽ` does not, or the other way round.
fn emit_kept(generator: &mut Generator<'_>, v: usize, x: usize, sandwich: &Sandwich) {
    let (versor, operand) = (generator.name(v), generator.name(x));
    let applied = sandwich.applied;
    let image = generator.kind(sandwich.result);
    let names = Names::new(image, None);
    let fields: Vec<String> = generator
        .kind(applied)
        .fields()
        .zip(generator.onto_fields(applied, &generator.general[sandwich.result][0]))
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
