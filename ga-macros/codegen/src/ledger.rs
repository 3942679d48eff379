//! One line per generated function: what it takes, gives and costs.

use std::fmt;

use crate::factor::Cost;

/// A generated function.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Entry {
    /// The operation and its operands, `Motor.apply(Point)`.
    pub function: String,
    /// The type of the result.
    pub result: String,
    /// Operation counts; `None` where the function hands on to another one.
    pub cost: Option<Cost>,
    /// The number of stored coefficients of the result.
    pub fields: usize,
    /// How the body was derived.
    pub form: String,
}

/// The operation counts of an algebra.
#[derive(Clone, Debug, Default)]
pub struct Ledger {
    /// The functions in the order generated.
    pub entries: Vec<Entry>,
    /// The number of tokens of the expansion.
    pub tokens: usize,
}

impl fmt::Display for Ledger {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(
            f,
            "function | result | multiplications | additions | fields | form | fused"
        )?;
        for entry in &self.entries {
            let counts = entry
                .cost
                .map(|cost| [cost.multiplications, cost.additions, cost.fused]);
            let [multiplications, additions, fused] = match counts {
                Some(counts) => counts.map(|count| count.to_string()),
                None => ["-"; 3].map(str::to_owned),
            };
            writeln!(
                f,
                "{} | {} | {multiplications} | {additions} | {} | {} | {fused}",
                entry.function, entry.result, entry.fields, entry.form
            )?;
        }
        writeln!(f, "tokens: {}", self.tokens)
    }
}
