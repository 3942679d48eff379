//! Instructions per call of the functions that matter, counted by callgrind and held to limits.
//!
//! `cargo bench --bench counts` counts the build with fused multiply-add and fails where a
//! function needs more than its line in `counts/limits.tsv` allows, with two in a hundred for
//! the compiler's moods. After a wanted change, or for a new compiler, `cargo bench --bench counts
//! -- --write` writes the limits anew: they are reviewed like code. `--here` counts the build
//! that the program itself is.
//!
//! The counting is done by valgrind, which is not a part of Rust; where it is missing, nothing
//! can be said, and the program says so and ends well. Against: `gungraun`, which needs a
//! program of its own of the very version installed besides, and keeps what it compares with
//! outside of the repository.

mod callgrind;
mod functions;
mod limits;

use std::process::ExitCode;

use ga_benches::builds::Build;

fn main() -> ExitCode {
    let asked = |option: &str| std::env::args().any(|argument| argument == option);
    let result = if asked("--call") {
        functions::call_all();
        Ok(())
    } else if asked("--here") {
        here()
    } else {
        limited(asked("--write"))
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(problem) => {
            eprintln!("{problem}");
            ExitCode::FAILURE
        }
    }
}

/// Prints what each function of this very build needs.
fn here() -> Result<(), String> {
    let counts = callgrind::instructions(functions::NAMES)?;
    for (name, count) in functions::NAMES.iter().zip(counts) {
        println!("{name}\t{:.1}", count as f64 / functions::CALLS as f64);
    }
    Ok(())
}

/// Counts the build with fused multiply-add, and compares with the limits or writes them.
fn limited(write: bool) -> Result<(), String> {
    if let Err(reason) = callgrind::is_there() {
        println!("nothing is counted: {reason}");
        return Ok(());
    }
    if !Build::V3.runs_here() {
        println!("nothing is counted: this machine has no fused multiply-add");
        return Ok(());
    }
    let counts = limits::read(&Build::V3.run("counts", &["--here"])?)?;
    match write {
        true => limits::write(&counts),
        false => limits::compare(&counts),
    }
}
