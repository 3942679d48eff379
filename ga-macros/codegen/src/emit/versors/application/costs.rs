//! What applications cost, in words and in the ledger: with the promise of being unit and without.

use crate::emit::Generator;
use crate::emit::expression;
use crate::factor::Cost;
use crate::ledger::Entry;

/// What an application costs.
#[derive(Clone, Copy)]
pub struct Costs {
    /// Of a unit versor.
    pub unit: Cost,
    /// Of any versor whose inverse is known.
    pub with: Cost,
    /// Of any versor, a division besides; `None` for types that are unit by declaration.
    pub divided: Option<Cost>,
}

impl Costs {
    /// The costs as sentences.
    pub fn sentence(costs: Option<Costs>) -> String {
        let sentence = costs.map(|costs| match costs.divided {
            None => format!(" Cost: at most {}.", expression::counts(costs.unit)),
            Some(divided) => format!(
                " Cost of a unit versor: at most {}; of any other: {}, 1 division.",
                expression::counts(costs.unit),
                expression::counts(divided)
            ),
        });
        sentence.unwrap_or_default()
    }
}

/// Notes what the application of a type costs, with and without the promise of being unit.
pub fn record(
    generator: &mut Generator<'_>,
    [v, x]: [usize; 2],
    output: usize,
    costs: Option<Costs>,
    form: &str,
) {
    let (versor, operand) = (generator.name(v), generator.name(x));
    let (result, kind) = (generator.name(output), generator.kind(output));
    let fields = kind.field_count();
    let mut entry = |function: String, cost: Option<Cost>| {
        generator.ledger.entries.push(Entry {
            function,
            result: result.clone(),
            cost,
            fields,
            form: form.to_owned(),
        });
    };
    match costs.map(|costs| (costs.unit, costs.divided)) {
        None => entry(format!("{versor}.apply({operand})"), None),
        Some((unit, None)) => entry(format!("{versor}.apply({operand})"), Some(unit)),
        Some((unit, Some(divided))) => {
            entry(format!("{versor}.apply({operand})"), Some(divided));
            entry(format!("Unit<{versor}>.apply({operand})"), Some(unit));
        }
    }
}
