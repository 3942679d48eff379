//! Conversions between types: widening that cannot fail, narrowing with a tolerance, and the sums
//! of different types, which widen both.

use std::fmt::Write;

use super::Generator;
use super::expression::{Names, code, doc, documentation};
use super::unrolled;
use crate::closure;
use crate::factor::Kernel;
use crate::model::Type;
use crate::poly::{Element, Poly};

impl Generator<'_> {
    /// The fields of a type that hold an element, each in the orientation as spelled.
    pub fn onto_fields(&self, index: usize, element: &Element) -> Vec<Poly> {
        let sign = |sign: i32| ga_core::Rational::from_integer(i128::from(sign));
        self.kind(index)
            .fields()
            .map(|slot| match element.get(&slot.mask) {
                Some(poly) => poly.scaled(&sign(slot.sign)),
                None => Poly::default(),
            })
            .collect()
    }
}

/// Emits the sums of different types and the products with references on the right.
pub fn conveniences(generator: &mut Generator<'_>) {
    let count = generator.model.types.len();
    let mut source = String::new();
    for a in 0..count {
        let name = generator.name(a);
        let all: Vec<String> = (0..count).map(|b| generator.name(b)).collect();
        let _ = writeln!(
            source,
            "algebra::references! {{ {name}: {} }}",
            all.join(", ")
        );
        for bound in ["Scalar", "Field"] {
            let sums: Vec<String> = (0..count)
                .filter(|&b| b != a)
                .filter(|&b| {
                    let fixed =
                        generator.kind(a).is_constrained() || generator.kind(b).is_constrained();
                    fixed == (bound == "Field")
                })
                .filter_map(|b| {
                    let sum = closure::sum_type_of_both(generator.model, a, b)?;
                    Some(format!("{} => {}", generator.name(b), generator.name(sum)))
                })
                .collect();
            if !sums.is_empty() {
                let _ = writeln!(
                    source,
                    "algebra::sums! {{ {bound} {name}: {} }}",
                    sums.join(", ")
                );
            }
        }
    }
    generator.source.push_str(&source);
}

/// Whether every value of the first type, given as its general element, is one of the second.
fn is_value(from: &Type, into: &Type, general: &Element) -> bool {
    closure::fits(into, general) && (from.null || !into.null)
}

/// Emits `From` for every pair in which the second type holds all values of the first, and
/// `TryFrom` the other way.
pub fn conversions(generator: &mut Generator<'_>) {
    let mut source = String::new();
    let count = generator.model.types.len();
    for a in 0..count {
        let element = &generator.general[a][0];
        let from = generator.name(a);
        let names = Names::new(generator.kind(a), None);
        let mut narrower = Vec::new();
        for b in (0..count).filter(|&b| b != a) {
            if is_value(generator.kind(a), generator.kind(b), element) {
                let kernel = Kernel::expanded(generator.onto_fields(b, element));
                let fields: Vec<String> = generator
                    .kind(b)
                    .fields()
                    .zip(&kernel.outputs)
                    .map(|(slot, poly)| {
                        format!(
                            "{}: {}",
                            slot.field,
                            code(poly, &names).replace("self.", "a.")
                        )
                    })
                    .collect();
                let into = generator.name(b);
                let bound = unrolled::bound(&kernel);
                let summary = "The same element: coefficients that the operand lacks are zero.";
                let documentation =
                    documentation(summary, &kernel, Some(generator.kind(b)), &names);
                let _ = writeln!(
                    source,
                    "impl<T: {bound}> From<{from}<T>> for {into}<T> {{ {} #[inline] \
                     fn from(a: {from}<T>) -> Self {{ {into} {{ {} }} }} }}",
                    doc(&documentation),
                    fields.join(", ")
                );
                let back = is_value(
                    generator.kind(b),
                    generator.kind(a),
                    &generator.general[b][0],
                );
                if !back {
                    narrower.push(into);
                }
            }
        }
        if !narrower.is_empty() {
            let _ = writeln!(
                source,
                "algebra::narrowing! {{ {from}: {} }}",
                narrower.join(", ")
            );
        }
    }
    generator.source.push_str(&source);
}
