//! Versor application: `V x̂ Ṽ` restricted to the grades of `x`, by the cheapest form known.

mod derivation;
mod duality;
mod kernels;

use std::fmt::Write;

use self::derivation::{Application, application, is_unit};
use self::duality::{Duality, HandedOn};
use super::{geometric_product, product_cost};
use crate::emit::Generator;
use crate::emit::expression::{self, Names};
use crate::emit::unrolled::{self, Function, Lists};
use crate::factor::{Cost, Kernel};
use crate::ledger::Entry;

/// What `V⁻¹` takes beside the multiplications and additions.
const DIVISION: &str = " A division besides.";

/// Emits sandwiches and applications of every type of one parity on every type.
pub fn applications(generator: &mut Generator<'_>) {
    let mut duality = Duality::new(generator);
    for v in duality.order() {
        if let Some(even) = generator.kind(v).parity() {
            applications_of(generator, &mut duality, v, even);
        }
    }
}

/// The functions of one versor type: unrolled, or entries of the lists of functions that call
/// others.
struct Emission {
    unrolled: Lists,
    /// Sandwiches of two products.
    composed: Vec<String>,
    /// Applications that are the sandwich, over the norm.
    applied: Vec<String>,
    /// Applications handed on by duality.
    handed_on: Vec<String>,
}

/// What is common to all applications of one versor type.
struct Versor {
    index: usize,
    /// Whether it is unit, so that the sandwich is the application.
    unit: bool,
    /// What the squared norm costs; `None` for a type of null elements only, such as a
    /// direction, which has sandwiches but is no versor.
    norm_cost: Option<Cost>,
}

fn applications_of(generator: &mut Generator<'_>, duality: &mut Duality, v: usize, even: bool) {
    let norm = super::norm_polynomial(generator, v);
    let invertible = !norm.is_zero();
    let versor = Versor {
        index: v,
        unit: is_unit(generator, v),
        norm_cost: invertible.then(|| Kernel::expanded(vec![norm]).cost()),
    };
    let name = generator.name(v);
    let mut emission = Emission {
        unrolled: Lists::new(name.clone()),
        composed: Vec::new(),
        applied: Vec::new(),
        handed_on: Vec::new(),
    };
    for x in duality.order() {
        let types = [v, x];
        let handed_on = duality.hand_on(generator, types);
        let mut handed_on = handed_on.filter(|_| invertible && !versor.unit);
        let mut derived = application(generator, types, even, handed_on.is_none());
        // What is handed on can lose a fixed coefficient that the application itself keeps.
        let output = handed_on.as_ref().map(|handed_on| handed_on.output);
        if output.is_some() && output != derived.as_ref().map(|derived| derived.applied) {
            handed_on = None;
            derived = application(generator, types, even, true);
        }
        let Some(application) = derived else {
            continue;
        };
        let sandwich_cost = sandwich(generator, &mut emission, &versor, x, &application);
        let Some(norm_cost) = versor.norm_cost else {
            continue;
        };
        match handed_on {
            Some(handed_on) => {
                hand_on(generator, &mut emission, types, &handed_on);
                duality.note(types, handed_on.output, handed_on.cost);
            }
            None => {
                let divided = sandwich_cost.map(|cost| match versor.unit {
                    true => cost,
                    false => {
                        let fields = generator.kind(application.applied).field_count();
                        cost + norm_cost + Cost::multiplying(fields)
                    }
                });
                let cost = apply(generator, &mut emission, &versor, x, &application, divided);
                duality.note(types, application.applied, cost);
            }
        }
    }
    emission.unrolled.write(&mut generator.source);
    let parity = if even { "even" } else { "odd" };
    let norm = if versor.unit { "unit" } else { "divided" };
    for (list, head) in [
        (
            emission.composed,
            format!("composed_sandwich! {{ {name} {parity}:"),
        ),
        (emission.applied, format!("application! {{ {name} {norm}:")),
        (emission.handed_on, format!("dual_application! {{ {name}:")),
    ] {
        if !list.is_empty() {
            let _ = writeln!(generator.source, "algebra::{head} {} }}", list.join(", "));
        }
    }
}

/// Emits `V x̂ Ṽ`; gives what it costs, where that is known.
fn sandwich(
    generator: &mut Generator<'_>,
    emission: &mut Emission,
    versor: &Versor,
    x: usize,
    application: &Application,
) -> Option<Cost> {
    let result = application.sandwich;
    if let Some(kernel) = &application.sandwich_kernel {
        let doc = match versor.unit {
            true => "The unit versor applied to `x`, `V x̂ Ṽ` (2.28).",
            false => "The sandwich `V x̂ Ṽ`, which is `V x̂ V⁻¹` (2.28) times `V Ṽ`.",
        };
        let names = ["Sandwich", "sandwich"];
        let types = [versor.index, x, result];
        emit_kernel(generator, &mut emission.unrolled, types, names, kernel, doc);
        return Some(kernel.cost());
    }
    let cost = composed_cost(generator, versor.index, x);
    let doc = format!(
        " `V x̂ Ṽ` as two products, restricted to the grades of `x`.{}",
        expression::cost_sentence(cost)
    );
    let (operand, result) = (generator.name(x), generator.name(result));
    emission
        .composed
        .push(format!("{operand} => {result} {doc:?}"));
    cost
}

/// Emits `V x̂ V⁻¹`; gives what it costs, where that is known.
fn apply(
    generator: &mut Generator<'_>,
    emission: &mut Emission,
    versor: &Versor,
    x: usize,
    application: &Application,
    divided: Option<Cost>,
) -> Option<Cost> {
    if let Some(kernel) = &application.applied_kernel {
        let doc = "The versor applied to `x`, `V x̂ V⁻¹` (2.28).";
        let names = ["Apply", "apply"];
        let types = [versor.index, x, application.applied];
        emit_kernel(generator, &mut emission.unrolled, types, names, kernel, doc);
        return Some(kernel.cost());
    }
    let fixed = !versor.unit && generator.kind(application.applied).has_fixed();
    if application.applied != application.sandwich || fixed {
        emit_kept(generator, versor.index, x, application, divided);
        return divided;
    }
    let summary = match versor.unit {
        true => "The unit versor applied to `x`, `V x̂ Ṽ` (2.28).",
        false => "The versor applied to `x`, `V x̂ V⁻¹` (2.28): the sandwich over the norm.",
    };
    let division = if versor.unit { "" } else { DIVISION };
    let doc = format!(" {summary}{}{division}", expression::cost_sentence(divided));
    emission
        .applied
        .push(format!("{} {doc:?}", generator.name(x)));
    divided
}

/// Emits an application that duality hands on to another one.
fn hand_on(
    generator: &mut Generator<'_>,
    emission: &mut Emission,
    [v, x]: [usize; 2],
    handed_on: &HandedOn,
) {
    let (versor, operand) = (generator.name(v), generator.name(x));
    let [base_versor, base_operand] = handed_on.base.map(|index| generator.name(index));
    let output = generator.name(handed_on.output);
    let doc = format!(
        " The versor applied to `x`, `V x̂ V⁻¹` (2.28), by duality from \
         `{base_versor}.apply({base_operand})`: `{}`.{}{DIVISION}",
        handed_on.rule,
        expression::cost_sentence(handed_on.cost)
    );
    let form = handed_on.form;
    emission
        .handed_on
        .push(format!("{form} {operand} => {output} {doc:?}"));
    generator.record(Entry {
        function: format!("{versor}.apply({operand})"),
        fields: generator.kind(handed_on.output).field_count(),
        result: output,
        cost: handed_on.cost,
        form: handed_on.rule.to_owned(),
    });
}

/// What a sandwich of two products costs at most; blades that the operand's grades leave out are
/// computed all the same. `None` where a product has no type.
fn composed_cost(generator: &Generator<'_>, v: usize, x: usize) -> Option<Cost> {
    let (between, first) = geometric_product(generator, v, x)?;
    Some(first + product_cost(generator, between, v)?)
}

fn emit_kernel(
    generator: &mut Generator<'_>,
    lists: &mut Lists,
    [v, x, result]: [usize; 3],
    [trait_name, method]: [&'static str; 2],
    kernel: &Kernel,
    doc: &str,
) {
    generator.check(kernel);
    let names = Names::new(generator.kind(v), Some(("x", generator.kind(x))));
    let kind = generator.kind(result);
    let documentation = expression::documentation(doc, kernel, Some(kind), &names);
    let body = expression::body(kernel, Some(kind), &names);
    let (versor, operand, output) = (generator.name(v), generator.name(x), generator.name(result));
    let fields = kind.field_count();
    lists.push(&Function {
        trait_name,
        method,
        bound: unrolled::bound(kernel),
        argument: ("x", &operand),
        output: &format!("{output}<T>"),
        documentation: &documentation,
        body: &body,
    });
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
fn emit_kept(
    generator: &mut Generator<'_>,
    v: usize,
    x: usize,
    sandwich: &Application,
    cost: Option<Cost>,
) {
    let (versor, operand) = (generator.name(v), generator.name(x));
    let applied = sandwich.applied;
    let image = generator.kind(sandwich.sandwich);
    let names = Names::new(generator.kind(v), Some(("y", image)));
    let fields: Vec<String> = generator
        .kind(applied)
        .fields()
        .zip(generator.onto_fields(applied, &generator.general[sandwich.sandwich][1]))
        .map(|(slot, poly)| {
            let value = match poly.is_zero() {
                true => "T::ZERO".to_owned(),
                false => format!("({}) * f", expression::code(&poly, &names)),
            };
            format!("{}: {value}", slot.field)
        })
        .collect();
    let output = generator.name(applied);
    let documentation = format!(
        " The versor applied to `x`, `V x̂ V⁻¹` (2.28), which keeps the fixed coefficients: the \
         others of the sandwich over the norm.{}{DIVISION}",
        expression::cost_sentence(cost)
    );
    let _ = writeln!(
        generator.source,
        "impl<T: Field> Apply<{operand}<T>> for {versor}<T> {{ type Output = {output}<T>; \
         #[doc = {documentation:?}] #[inline] fn apply(self, x: {operand}<T>) -> {output}<T> {{ \
         let y = self.sandwich(x); let f = T::ONE / self.norm_squared(); \
         {output} {{ {} }} }} }}",
        fields.join(", ")
    );
}
