//! Decides how results reach standard output, and remarks standard error, without ever panicking.

use crate::failure::Failure;
use serde::Serialize;
use std::io::{self, ErrorKind, Write};

/// Prints a text.
///
/// # Errors
/// [`Failure::Closed`] if nobody reads any more, [`Failure::Output`] if it cannot be written.
pub fn print(text: &str) -> Result<(), Failure> {
    let mut stdout = io::stdout().lock();
    let written = stdout
        .write_all(text.as_bytes())
        .and_then(|()| stdout.flush());
    written.map_err(|error| match error.kind() {
        ErrorKind::BrokenPipe => Failure::Closed,
        _ => Failure::Output(error),
    })
}

/// Prints a value as JSON.
///
/// # Errors
/// As [`print()`], and [`Failure::Json`] if the value has no JSON form.
pub fn print_json(value: &impl Serialize) -> Result<(), Failure> {
    print(&json(value)?)
}

/// A value as JSON, with a line break at its end.
///
/// # Errors
/// [`Failure::Json`] if the value has no JSON form.
pub fn json(value: &impl Serialize) -> Result<String, Failure> {
    let mut text = serde_json::to_string_pretty(value)?;
    text.push('\n');
    Ok(text)
}

/// Prints a remark to standard error, where it does not mix with results.
pub fn remark(text: &str) {
    // A remark that nobody can read is no reason to stop.
    let _ = writeln!(io::stderr(), "{text}");
}

/// Rows of words in columns that are as wide as their widest word, two blanks apart; the first column
/// is aligned left, numbers right.
pub fn table(rows: &[Vec<String>]) -> String {
    let columns = rows.iter().map(Vec::len).max().unwrap_or(0);
    let cells = |column: usize| rows.iter().filter_map(move |row| row.get(column));
    let widths: Vec<usize> = (0..columns)
        .map(|column| {
            cells(column)
                .map(|cell| cell.chars().count())
                .max()
                .unwrap_or(0)
        })
        .collect();
    let mut text = String::new();
    for row in rows {
        let mut line = String::new();
        for (cell, width) in row.iter().zip(&widths) {
            let is_number = cell == "-" || cell.parse::<f64>().is_ok();
            if is_number {
                line.push_str(&format!("{cell:>width$}  "));
            } else {
                line.push_str(&format!("{cell:<width$}  "));
            }
        }
        text.push_str(line.trim_end());
        text.push('\n');
    }
    text
}

#[cfg(test)]
mod tests {
    use super::table;

    #[test]
    fn columns_are_as_wide_as_their_widest_word() {
        let rows = [["atom", "number"], ["Si", "3"], ["O", "16"]];
        let rows = rows.map(|row| row.map(str::to_owned).to_vec());
        assert_eq!(table(&rows), "atom  number\nSi         3\nO         16\n");
    }
}
