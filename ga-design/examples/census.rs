//! Reads CIF files and prints a line for each: what was found, to be compared with what another
//! program finds in them.
//!
//! The names of the files come from standard input, one a line:
//! `find FOLDER -name '*.cif' | cargo run --release -p ga-design --example census`. The columns are
//! the name of the file, the number of the space group (0 where it is not known), the Hermann–Mauguin
//! symbol, the six cell parameters, the volume, and the atoms of the unit cell per element; or the
//! name, `error`, and the message.

use ga_design::crystallography::{Expansion, cif};
use std::collections::BTreeMap;
use std::io::{self, BufRead, Write};

fn main() -> io::Result<()> {
    let mut out = io::BufWriter::new(io::stdout().lock());
    for file in io::stdin().lock().lines() {
        let file = file?;
        match line(&file) {
            Ok(found) => writeln!(out, "{file}\t{found}")?,
            Err(message) => writeln!(out, "{file}\terror\t{message}")?,
        }
    }
    out.flush()
}

/// The columns after the name of a file.
fn line(file: &str) -> Result<String, Box<dyn std::error::Error>> {
    let crystal = cif::read_file(file)?.crystal;
    let mut elements: BTreeMap<&str, usize> = BTreeMap::new();
    for atom in Expansion::default().unit_cell(&crystal)? {
        *elements.entry(atom.element.symbol()).or_default() += 1;
    }
    let [a, b, c] = crystal.cell.edges();
    let [alpha, beta, gamma] = crystal.cell.angles();
    let counts = elements
        .iter()
        .map(|(element, count)| format!("{element}{count}"));
    Ok(format!(
        "{}\t{}\t{a} {b} {c} {alpha} {beta} {gamma}\t{}\t{}",
        crystal.number.unwrap_or(0),
        crystal.hermann_mauguin.as_deref().unwrap_or("?"),
        crystal.cell.volume(),
        counts.collect::<Vec<_>>().join(" "),
    ))
}
