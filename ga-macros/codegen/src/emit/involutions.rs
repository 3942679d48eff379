//! Operations of one operand that are linear: involutions, duals and complements.

use std::fmt::Write;

use ga_core::{Blade, Involution, Rational, dual};

use super::Generator;
use super::expression::{self, Names};
use super::unrolled;
use crate::closure;
use crate::factor::Kernel;
use crate::ledger::Entry;
use crate::poly::{Element, graded_signs};

/// Emits the involutions and duals of every type.
pub fn involutions(generator: &mut Generator<'_>) {
    for a in 0..generator.model.types.len() {
        let element = generator.general[a][0].clone();
        for involution in Involution::ALL {
            let image = graded_signs(&element, |grade| involution.sign(grade));
            let (trait_name, method) = (involution.trait_name(), involution.method());
            linear(generator, a, &image, trait_name, method, involution.doc());
        }
        complements(generator, a, &element);
        if !generator.model.metric.is_degenerate() {
            duals(generator, a);
        }
    }
}

fn complements(generator: &mut Generator<'_>, a: usize, element: &Element) {
    let dimension = generator.model.dimension();
    let signed =
        |(blade, sign): (Blade, i32)| vec![(blade, Rational::from_integer(i128::from(sign)))];
    let right = image(element, |blade| {
        Some(signed(dual::right_complement(dimension, blade)))
    });
    let left = image(element, |blade| {
        Some(signed(dual::left_complement(dimension, blade)))
    });
    if let Some(right) = right {
        let doc = "The right complement: `e ∧ right_complement(e) = I` for every basis blade.";
        linear(
            generator,
            a,
            &right,
            "RightComplement",
            "right_complement",
            doc,
        );
    }
    if let Some(left) = left {
        let doc = "The left complement: `left_complement(e) ∧ e = I` for every basis blade.";
        linear(
            generator,
            a,
            &left,
            "LeftComplement",
            "left_complement",
            doc,
        );
    }
}

/// The dual of the general element of a type; `None` where the metric has no duals.
pub fn dual_image(generator: &Generator<'_>, a: usize) -> Option<Element> {
    let metric = &generator.model.metric;
    image(&generator.general[a][0], |blade| dual::dual(metric, blade))
}

/// What the general element of a type is the dual of.
pub fn undual_image(generator: &Generator<'_>, a: usize) -> Option<Element> {
    let metric = &generator.model.metric;
    image(&generator.general[a][0], |blade| {
        dual::undual(metric, blade)
    })
}

fn duals(generator: &mut Generator<'_>, a: usize) {
    if let (Some(down), Some(up)) = (dual_image(generator, a), undual_image(generator, a)) {
        linear(generator, a, &down, "Dual", "dual", "The dual `A I⁻¹`.");
        linear(
            generator,
            a,
            &up,
            "Undual",
            "undual",
            "The inverse of the dual, `A I`.",
        );
    }
}

/// The image of an element under a linear map given on basis blades.
fn image(
    element: &Element,
    map: impl Fn(Blade) -> Option<Vec<(Blade, Rational)>>,
) -> Option<Element> {
    let mut result = Element::new();
    for (mask, poly) in element {
        for (blade, value) in map(Blade::new(*mask))? {
            result
                .entry(blade.mask())
                .or_default()
                .add_scaled(poly, &value);
        }
    }
    result.retain(|_, poly| !poly.is_zero());
    Some(result)
}

/// Emits a linear operation, into the same type where that holds the result.
fn linear(
    generator: &mut Generator<'_>,
    a: usize,
    image: &Element,
    trait_name: &str,
    method: &str,
    doc: &str,
) {
    // Involutions keep a square of 0, duals and complements need not.
    let kind = generator.kind(a);
    let keeps = Involution::ALL.iter().any(|own| own.method() == method);
    let same = match keeps {
        true => closure::fits(kind, image),
        false => closure::holds(kind, image),
    };
    let Some(result) = same
        .then_some(a)
        .or_else(|| closure::smallest(generator.model, image))
    else {
        return;
    };
    let names = Names::new(generator.kind(a), None);
    let kernel = Kernel::expanded(generator.onto_fields(result, image));
    generator.check(&kernel);
    let identity = *image == generator.general[a][0] && result == a;
    let body = if identity {
        "self".to_owned()
    } else {
        expression::linear_body(&kernel, generator.kind(result), &names)
    };
    let documentation =
        expression::documentation(doc, &kernel, Some(generator.kind(result)), &names);
    let (name, output) = (generator.name(a), generator.name(result));
    let bound = unrolled::bound(&kernel);
    let _ = writeln!(
        generator.source,
        "impl<T: {bound}> {trait_name} for {name}<T> {{ type Output = {output}<T>; {} #[inline] \
         fn {method}(self) -> {output}<T> {{ {body} }} }}",
        expression::doc(&documentation)
    );
    let fields = generator.kind(result).field_count();
    let function = format!("{name}.{method}()");
    let cost = Some(kernel.cost());
    generator.record(Entry {
        function,
        result: output,
        cost,
        fields,
        form: "expanded".into(),
    });
}
