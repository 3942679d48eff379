//! What a function may need: the table in the repository, and the comparison with it.

use std::fmt::Write;
use std::path::Path;

/// The limits, one function and its instructions a line.
const LIMITS: &str = include_str!("limits.tsv");

/// What the compiler may add without being asked why, as a part of the limit.
const SLACK: f64 = 0.02;

/// Instructions per call by the name of the function.
pub type Counts = Vec<(String, f64)>;

/// Counts from text, a name and a number a line.
///
/// # Errors
/// The line that is none of that.
pub fn read(text: &str) -> Result<Counts, String> {
    let line = |line: &str| {
        let (name, count) = line.split_once('\t')?;
        Some((name.to_owned(), count.trim().parse().ok()?))
    };
    text.lines()
        .filter(|text| !text.starts_with('#') && !text.is_empty())
        .map(|text| line(text).ok_or_else(|| format!("no count: {text}")))
        .collect()
}

/// Prints the counts beside their limits.
///
/// # Errors
/// The functions that are above their limits, and those that have none.
pub fn compare(counts: &Counts) -> Result<(), String> {
    let limits = read(LIMITS)?;
    let mut problems = String::new();
    println!("{:<36} {:>12} {:>9}", "function", "instructions", "limit");
    for (name, count) in counts {
        let limit = limits
            .iter()
            .find(|(known, _)| known == name)
            .map(|(_, limit)| *limit);
        match limit {
            Some(limit) => {
                println!("{name:<36} {count:>12.1} {limit:>9.1}");
                if *count > limit * (1.0 + SLACK) {
                    let _ = writeln!(
                        problems,
                        "{name} needs {count:.1} instructions, limit {limit:.1}"
                    );
                }
            }
            None => {
                println!("{name:<36} {count:>12.1} {:>9}", "-");
                let _ = writeln!(problems, "{name} has no limit");
            }
        }
    }
    for (name, _) in &limits {
        if !counts.iter().any(|(counted, _)| counted == name) {
            let _ = writeln!(problems, "{name} has a limit, but is not counted");
        }
    }
    match problems.is_empty() {
        true => Ok(()),
        false => Err(format!(
            "{problems}If this is wanted, write the limits anew: \
             cargo bench --bench counts -- --write"
        )),
    }
}

/// Writes the counts as the new limits.
///
/// # Errors
/// That the file cannot be written.
pub fn write(counts: &Counts) -> Result<(), String> {
    let mut text = String::from(
        "# Instructions per call on x86-64-v3, its loop included.\n\
         # Written by: cargo bench --bench counts -- --write\n",
    );
    for (name, count) in counts {
        let _ = writeln!(text, "{name}\t{count:.1}");
    }
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("counts/limits.tsv");
    std::fs::write(&path, text).map_err(|error| format!("{}: {error}", path.display()))?;
    println!("wrote {}", path.display());
    Ok(())
}
