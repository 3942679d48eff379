//! Versor application: `V x̂ Ṽ` restricted to the grades of `x`, by the cheapest form known; one
//! body serves the versors that are unit and those that are divided by their norm.

mod costs;
mod derivation;
mod duality;
mod kernels;
mod matrix;
mod null;

use std::fmt::Write;

use self::costs::{Costs, record};
use self::derivation::{Application, application, is_unit};
use self::duality::{Duality, HandedOn};
use self::kernels::multiples_read;
use self::matrix::Candidate;
use super::{geometric_product, product_cost};
use crate::emit::Generator;
use crate::emit::expression::{self, Names};
use crate::emit::unrolled::{self, Function, Lists};
use crate::factor::{Cost, Kernel};
use crate::ledger::Entry;
use crate::model::Type;

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
    /// The type of its multiples.
    multiple: usize,
}

impl Versor {
    /// The costs of an application whose unit form costs so much, and any other that much more:
    /// with a known inverse, and without.
    fn costs(&self, unit: Cost, [known, more]: [Cost; 2]) -> Costs {
        Costs {
            unit,
            with: unit + known,
            divided: (!self.unit).then_some(unit + more),
        }
    }
}

fn applications_of(generator: &mut Generator<'_>, duality: &mut Duality, v: usize, even: bool) {
    let norm = super::norm_polynomial(generator, v);
    // Of one grade, V Ṽ is the square up to sign.
    let kind = generator.kind(v);
    let null = kind.null && kind.grades().is_power_of_two();
    let invertible = !norm.is_zero() && !null;
    let versor = Versor {
        index: v,
        unit: is_unit(generator, v),
        norm_cost: invertible.then(|| Kernel::expanded(vec![norm]).cost()),
        multiple: generator.sums[v].unwrap_or(v),
    };
    let name = generator.name(v);
    if invertible {
        declare(generator, &versor);
    }
    let mut emission = Emission {
        unrolled: Lists::new(name.clone()),
        composed: Vec::new(),
        applied: Vec::new(),
        handed_on: Vec::new(),
    };
    let mut matrices = Vec::new();
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
                hand_on(generator, &mut emission, x, &handed_on);
                record(
                    generator,
                    types,
                    handed_on.output,
                    handed_on.costs,
                    handed_on.rule,
                );
                duality.note(types, handed_on.output, handed_on.costs);
                matrices.push((x, Candidate::HandedOn(handed_on)));
            }
            None => {
                let fields = generator.kind(application.applied).field_count();
                let more = norm_cost + Cost::multiplying(fields);
                let by_sandwich = sandwich_cost.map(|cost| versor.costs(cost, [more; 2]));
                let costs = apply(
                    generator,
                    &mut emission,
                    &versor,
                    x,
                    &application,
                    by_sandwich,
                );
                duality.note(types, application.applied, costs);
                let unrolled = application.is_unrolled();
                let pattern = application
                    .pattern
                    .filter(|pattern| matrix::is_wanted(generator, pattern, unrolled));
                let own =
                    pattern.map(|pattern| Candidate::Own(pattern, application.applied, costs));
                matrices.extend(own.map(|own| (x, own)));
            }
        }
    }
    emission.unrolled.write(&mut generator.source);
    let parity = if even { "even" } else { "odd" };
    let applied = match versor.unit {
        true => format!("application! {{ {name} Field unit:"),
        false => {
            let multiple = generator.name(versor.multiple);
            format!("application! {{ {name} {multiple} divided:")
        }
    };
    let sign = Duality::sign(generator);
    for (list, head) in [
        (
            emission.composed,
            format!("composed_sandwich! {{ {name} {parity}:"),
        ),
        (emission.applied, applied),
        (
            emission.handed_on,
            format!("dual_application! {{ {name} {sign}:"),
        ),
    ] {
        if !list.is_empty() {
            let _ = writeln!(generator.source, "algebra::{head} {} }}", list.join(", "));
        }
    }
    matrix::matrices(generator, duality, v, matrices);
}

/// Emits what all applications of a versor type have in common.
fn declare(generator: &mut Generator<'_>, versor: &Versor) {
    let kind = generator.kind(versor.index);
    let name = generator.name(versor.index);
    let rule = match (versor.unit, kind.has_fixed()) {
        (false, _) => format!("divided {}", generator.name(versor.multiple)),
        (true, false) => "promised".to_owned(),
        (true, true) => "fixed".to_owned(),
    };
    let number = number_of(kind);
    let _ = writeln!(
        generator.source,
        "algebra::versor! {{ {name} {number} {rule} }}"
    );
}

/// The bound on the numbers of a versor type: fractions among its fixed coefficients ask for a
/// field.
fn number_of(kind: &Type) -> &'static str {
    if kind.has_fractions() {
        "Field"
    } else {
        "Number"
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

/// Emits the application of a type; gives what it costs, where that is known.
fn apply(
    generator: &mut Generator<'_>,
    emission: &mut Emission,
    versor: &Versor,
    x: usize,
    application: &Application,
    by_sandwich: Option<Costs>,
) -> Option<Costs> {
    let types = [versor.index, x];
    if let Some(kernel) = &application.applied_kernel {
        let list = &mut emission.unrolled;
        let costs = emit_application(generator, list, versor, x, application.applied, kernel);
        record(
            generator,
            types,
            application.applied,
            Some(costs),
            &kernel.form,
        );
        return Some(costs);
    }
    let form = match &application.sandwich_kernel {
        Some(kernel) => &*kernel.form,
        None => "(V x) Ṽ as two products",
    };
    record(generator, types, application.applied, by_sandwich, form);
    let (operand, output) = (generator.name(x), generator.name(application.applied));
    let cost = Costs::sentence(by_sandwich);
    emission.applied.push(if versor.unit {
        let doc = format!(" The unit versor applied to `x`, `V x̂ Ṽ` (2.28).{cost}");
        format!("{operand} {doc:?}")
    } else {
        let doc = format!(
            " The versor applied to `x` (2.28): the sandwich, over the norm of a versor that is \
             not unit.{cost}"
        );
        format!("{operand} => {output} {doc:?}")
    });
    by_sandwich
}

/// Emits the body of an application, for whatever multiple of the versor is its inverse; gives
/// what it costs.
fn emit_application(
    generator: &mut Generator<'_>,
    lists: &mut Lists,
    versor: &Versor,
    x: usize,
    result: usize,
    kernel: &Kernel,
) -> Costs {
    generator.check(kernel);
    let kind = generator.kind(versor.index);
    let names = Names::new(kind, Some(("x", generator.kind(x))))
        .with_multiple(generator.kind(versor.multiple));
    let read = multiples_read(kernel);
    let norm = versor.norm_cost.filter(|_| read > 0);
    let more = norm.unwrap_or_default() + Cost::multiplying(read);
    let costs = versor.costs(kernel.cost(), [Cost::default(), more]);
    let division = if read > 0 { ", 1 division" } else { "" };
    let summary = format!(
        "The versor applied to `x` (2.28): `V x̂ W̃`, where `w` is the versor itself if that is \
         unit. Of any other it is `V/(V Ṽ)`, and the cost is {}{division}.",
        expression::counts(kernel.cost() + more)
    );
    let output = generator.kind(result);
    let documentation = expression::documentation(&summary, kernel, Some(output), &names);
    let body = expression::body(kernel, Some(output), &names);
    let bound = match number_of(kind) {
        "Field" => "Field",
        _ => unrolled::bound(kernel),
    };
    lists.push(&Function {
        trait_name: "ApplyUnit",
        method: "apply_with",
        bound,
        between: Some((
            if read > 0 { "w" } else { "_w" },
            &generator.name(versor.multiple),
        )),
        argument: ("x", &generator.name(x)),
        output: &format!("{}<T>", output.name),
        documentation: &documentation,
        body: &body,
    });
    costs
}

/// Emits an application that duality hands on to another one.
fn hand_on(generator: &Generator<'_>, emission: &mut Emission, x: usize, handed_on: &HandedOn) {
    let operand = generator.name(x);
    let [base_versor, base_operand] = handed_on.base.map(|index| generator.name(index));
    let output = generator.name(handed_on.output);
    let doc = format!(
        " The versor applied to `x` (2.28), by duality from \
         `{base_versor}.apply({base_operand})`: `{}`.{}",
        handed_on.rule,
        Costs::sentence(handed_on.costs)
    );
    let form = handed_on.form;
    emission
        .handed_on
        .push(format!("{form} {operand} => {output} {doc:?}"));
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
        between: None,
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
        form: kernel.form.to_string(),
    });
}
