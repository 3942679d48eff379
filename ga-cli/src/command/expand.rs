//! `articulate expand`: the Rust that `define_algebra!` makes of a metric, or what it costs.

mod source;

use crate::failure::Failure;
use crate::{output, progress};
use serde::Serialize;
use std::path::PathBuf;

/// Prints the Rust that define_algebra! generates, or the operation count of each function.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Arguments {
    /// A signature such as R3, R3_0_1 or R4_1; or a file with the body of a define_algebra! call, or
    /// with Rust source that holds such calls.
    #[arg(value_name = "SIGNATURE|FILE")]
    algebra: PathBuf,
    /// Print one line for each function instead: what it gives, its multiplications and additions,
    /// the fields of its result, how it was derived, and its operations where an addition and the
    /// product that it adds are one.
    #[arg(long)]
    ledger: bool,
    /// Print the Rust or the ledger as JSON.
    #[arg(long, help = JSON)]
    json: bool,
}

const EXAMPLES: &str = "Examples:
  articulate expand R3 > r3.rs
  articulate expand R4_1 --ledger | grep apply
  articulate expand src/algebra.rs --ledger --json";

const JSON: &str = "Print JSON: {source}, or with --ledger {functions:[{function, result, multiplications, \
                    additions, fields, form, fused}], tokens}; a count is null where a function hands on to \
                    another";

#[derive(Serialize)]
struct Source {
    source: String,
}

#[derive(Default, Serialize)]
struct Ledger {
    functions: Vec<Function>,
    tokens: usize,
}

#[derive(Serialize)]
struct Function {
    function: String,
    result: String,
    multiplications: Option<usize>,
    additions: Option<usize>,
    fields: usize,
    form: String,
    fused: Option<usize>,
}

/// Expands the algebra and prints what was asked for.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let calls = source::calls(&arguments.algebra)?;
    let mark = progress::waiting("expanding");
    let result = if arguments.ledger {
        ledger(&calls).map(Printed::Ledger)
    } else {
        expansion(&calls).map(Printed::Source)
    };
    mark.finish_and_clear();
    match (result?, arguments.json) {
        (Printed::Ledger(ledger), true) => output::print_json(&ledger),
        (Printed::Ledger(ledger), false) => output::print(&aligned(&ledger)),
        (Printed::Source(source), true) => output::print_json(&Source { source }),
        (Printed::Source(source), false) => output::print(&source),
    }
}

enum Printed {
    Ledger(Ledger),
    Source(String),
}

fn expansion(calls: &source::Calls) -> Result<String, Failure> {
    let expanded = calls.texts.iter().map(|text| ga_codegen::try_expand(text));
    let expanded = expanded.collect::<Result<Vec<_>, _>>();
    Ok(expanded
        .map_err(|mistakes| calls.mistaken(&mistakes))?
        .join("\n"))
}

fn ledger(calls: &source::Calls) -> Result<Ledger, Failure> {
    let mut all = Ledger::default();
    for text in &calls.texts {
        let one = ga_codegen::ledger(text).map_err(|mistakes| calls.mistaken(&mistakes))?;
        all.tokens += one.tokens;
        all.functions
            .extend(one.entries.into_iter().map(|entry| Function {
                function: entry.function,
                result: entry.result,
                multiplications: entry.cost.map(|cost| cost.multiplications),
                additions: entry.cost.map(|cost| cost.additions),
                fields: entry.fields,
                form: entry.form,
                fused: entry.cost.map(|cost| cost.fused),
            }));
    }
    Ok(all)
}

/// The ledger for people, in columns.
fn aligned(ledger: &Ledger) -> String {
    let heading = [
        "function",
        "result",
        "multiplications",
        "additions",
        "fields",
        "form",
        "fused",
    ]
    .map(str::to_owned);
    let count = |count: Option<usize>| count.map_or_else(|| "-".to_owned(), |n| n.to_string());
    let mut rows = vec![heading.to_vec()];
    rows.extend(ledger.functions.iter().map(|row| {
        vec![
            row.function.clone(),
            row.result.clone(),
            count(row.multiplications),
            count(row.additions),
            row.fields.to_string(),
            row.form.clone(),
            count(row.fused),
        ]
    }));
    format!("{}{} tokens\n", output::table(&rows), ledger.tokens)
}
