//! The same operations on the same data, in one process, by this library and by those that one
//! would take instead: `cargo bench --bench peers` prints a table for each build.
//!
//! A row is the operation, the type of the numbers, the nanoseconds that this library takes for
//! one element, the fastest other library and its nanoseconds, and the ratio of the two. Results
//! are compared before anything is timed. The program compiles and runs itself again for each
//! build; with `--here` it is content with the build it is, and with `--only motor` it measures
//! the operations whose names contain that.
//!
//! This library is called as one would first: by a loop over structs, and one motor on many points
//! by `apply_slice`. Rows that end in `-by-slices` are the functions of `ga_lanes::slices` on the
//! same structs, those that end in `-in-batches` the same coefficient by coefficient, both against
//! the same others.
//!
//! `clifford` takes longer to compile than all the rest together, and takes part with `--features
//! clifford`. Not compared: `g3` needs a nightly compiler, `wedged` knows no metric but the
//! Euclidean, `geonum` has numbers with angles instead of multivectors, `cga` and `pga` are names
//! without code.

mod clifford;
mod conformal;
mod euclidean;
mod others;
mod plane_based;
mod remarks;
mod table;

use std::process::ExitCode;

use ga_benches::builds::Build;
use table::Table;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().collect();
    let mut after = arguments
        .iter()
        .skip_while(|argument| *argument != "--only");
    let only = after.nth(1).map_or("", String::as_str);
    let results = match arguments.iter().any(|argument| argument == "--here") {
        true => vec![here(only)],
        false => Build::ALL
            .into_iter()
            .map(|build| table_of(build, only))
            .collect(),
    };
    match results.into_iter().collect() {
        Ok(()) => ExitCode::SUCCESS,
        Err(problem) => {
            eprintln!("{problem}");
            ExitCode::FAILURE
        }
    }
}

/// Prints the table of the build that this is.
fn here(only: &str) -> Result<(), String> {
    let mut table = Table::of(only.to_owned());
    euclidean::run(&mut table);
    plane_based::run(&mut table);
    conformal::run(&mut table);
    print!("{table}");
    match table.disagreements.is_empty() {
        true => Ok(()),
        false => Err(table.disagreements.join("\n")),
    }
}

/// Prints the table of one of the builds.
fn table_of(build: Build, only: &str) -> Result<(), String> {
    println!("{} {}", build.name(), build.flags());
    if build.is_this() {
        here(only)?;
    } else if build.runs_here() {
        print!("{}", build.run("peers", &["--here", "--only", only])?);
    } else {
        println!("not on this machine");
    }
    println!();
    Ok(())
}
