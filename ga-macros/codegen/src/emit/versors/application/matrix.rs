//! The matrices of applications: which entries can differ from zero, and from how many elements on
//! they are worthwhile.

use std::collections::HashSet;
use std::fmt::Write;

use super::costs::Costs;
use super::duality::{Duality, HandedOn};
use crate::emit::Generator;
use crate::factor::Cost;
use crate::ledger::Entry;
use crate::poly::Element;

/// The highest dimension in which every application has a matrix; beyond, those with a body of
/// their own.
const ALL_UP_TO: usize = 4;
/// How many entries a matrix may have.
const LARGEST: usize = 128;

/// The entries of a matrix that can differ from zero, by row.
pub struct Pattern(Vec<Row>);

/// A field of the result.
struct Row {
    /// The fields of the operand that it depends on.
    columns: Vec<usize>,
    /// Whether the fixed coefficients of the operand contribute to it.
    constant: bool,
}

/// What an application is as a polynomial, `V x̂ Ṽ`, seen as a matrix.
pub fn pattern(generator: &Generator<'_>, [result, x]: [usize; 2], whole: &Element) -> Pattern {
    let slots = generator.kind(x).slots.iter().enumerate();
    let stored: Vec<usize> = slots
        .filter(|(_, slot)| slot.fixed.is_none())
        .map(|(place, _)| place)
        .collect();
    let rows = generator.kind(result).fields().map(|field| {
        let terms = whole
            .get(&field.mask)
            .into_iter()
            .flat_map(|poly| poly.terms());
        // The slot of the operand in each term; none where a fixed coefficient stands.
        let slots: HashSet<Option<u16>> = terms
            .map(|(monomial, _)| {
                let mut variables = monomial.variables();
                variables.find(|v| v.operand == 1).map(|v| v.slot)
            })
            .collect();
        let occurs = |column: &usize| slots.contains(&Some(stored[*column] as u16));
        Row {
            columns: (0..stored.len()).filter(occurs).collect(),
            constant: slots.contains(&None),
        }
    });
    Pattern(rows.collect())
}

impl Pattern {
    /// How many entries are stored.
    fn entries(&self) -> usize {
        let rows = self.0.iter();
        rows.map(|row| row.columns.len() + usize::from(row.constant))
            .sum()
    }

    /// What the matrix costs on one element.
    fn cost(&self) -> Cost {
        let rows = self.0.iter();
        rows.map(|row| Cost {
            // The constant opens the sum.
            fused: row.columns.len(),
            multiplications: row.columns.len(),
            additions: (row.columns.len() + usize::from(row.constant)).saturating_sub(1),
        })
        .fold(Cost::default(), |sum, row| sum + row)
    }
}

/// An application that has a matrix if all it needs is generated.
pub enum Candidate {
    /// A pattern of its own, the type of the result, and what the application costs.
    Own(Pattern, usize, Option<Costs>),
    /// The matrix of another application.
    HandedOn(HandedOn),
}

/// Whether an application gets a matrix, given whether it has a body of its own.
pub fn is_wanted(generator: &Generator<'_>, pattern: &Pattern, unrolled: bool) -> bool {
    let all = generator.model.dimension() <= ALL_UP_TO;
    (all || unrolled) && pattern.entries() <= LARGEST
}

/// Emits the matrices of one versor type.
pub fn matrices(
    generator: &mut Generator<'_>,
    duality: &mut Duality,
    v: usize,
    candidates: Vec<(usize, Candidate)>,
) {
    let name = generator.name(v);
    let (mut own, mut handed_on) = (String::new(), Vec::new());
    for (x, candidate) in candidates {
        let types = [v, x];
        match candidate {
            Candidate::Own(pattern, result, costs) => {
                let linear = generator.sums[x];
                let column = linear.and_then(|linear| duality.costs([v, linear]));
                let (Some(linear), Some(column)) = (linear, column) else {
                    continue;
                };
                let cost = pattern.cost();
                let kind = generator.kind(x);
                let columns = kind.field_count() + usize::from(kind.has_fixed());
                let building = columns * column.map_or(0, |costs| costs.with.multiplications);
                let apply = costs.map_or(0, |costs| costs.unit.multiplications);
                let spared = apply.saturating_sub(cost.multiplications);
                let least = building.checked_div(spared).map_or(0, |least| least + 1);
                let _ = write!(
                    own,
                    "{} in {} {} => {} {least} {{",
                    generator.name(x),
                    generator.name(linear),
                    kind.field_count(),
                    generator.name(result)
                );
                for (field, row) in generator.kind(result).fields().zip(&pattern.0) {
                    let sign = if row.constant { '+' } else { '-' };
                    let columns: Vec<String> = row.columns.iter().map(usize::to_string).collect();
                    let _ = write!(own, "{} {sign} [{}] ", field.field, columns.join(" "));
                }
                own.push_str("} ");
                let form = format!("matrix, from {columns} columns");
                record(generator, types, result, (cost, pattern.entries()), form);
                duality.note_matrix(types, (cost, pattern.entries()));
            }
            Candidate::HandedOn(dual) => {
                let Some(known) = duality.matrix(dual.base) else {
                    continue;
                };
                let base = if dual.base[0] == v {
                    dual.base[1]
                } else {
                    dual.base[0]
                };
                let (operand, base) = (generator.name(x), generator.name(base));
                let output = generator.name(dual.output);
                handed_on.push(format!("{} {operand} {base} => {output}", dual.form));
                record(generator, types, dual.output, known, dual.rule.to_owned());
                duality.note_matrix(types, known);
            }
        }
    }
    if !own.is_empty() {
        let _ = writeln!(generator.source, "algebra::linear_maps! {{ {name}: {own}}}");
    }
    if !handed_on.is_empty() {
        let sign = Duality::sign(generator);
        let list = handed_on.join(", ");
        let _ = writeln!(
            generator.source,
            "algebra::dual_linear_maps! {{ {name} {sign}: {list} }}"
        );
    }
}

/// Notes what a matrix costs on one element, and its entries in place of fields.
fn record(
    generator: &mut Generator<'_>,
    [v, x]: [usize; 2],
    result: usize,
    (cost, entries): (Cost, usize),
    form: String,
) {
    let entry = Entry {
        function: format!("{}.linear_map({})", generator.name(v), generator.name(x)),
        result: generator.name(result),
        cost: Some(cost),
        fields: entries,
        form,
    };
    generator.record(entry);
}
