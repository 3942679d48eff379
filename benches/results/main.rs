//! Runs every measurement and writes what they print to `benches/RESULTS.md`, with the machine,
//! the date, the compiler and the flags: `cargo bench --bench results`.

mod machine;

use std::fmt::Write;
use std::path::Path;
use std::process::{Command, ExitCode};

/// A section of the page: the bench, its heading, and what is to be known for reading it.
const SECTIONS: [(&str, &str, &str); 6] = [
    (
        "peers",
        "Beside other libraries",
        "Nanoseconds an element, out\\[i\\] = f(a\\[i\\], b\\[i\\]) over 4096 elements as arrays of \
         structs, all in one process and in turns, the fastest of many windows. `ratio` is ours \
         over the best other. Rows of the conformal model tell how many times as long they take \
         as a rigid motion of a point by nalgebra, timed in turns with them.",
    ),
    (
        "operations",
        "Operations",
        "What the ledgers count: multiplications, doublings apart, additions, and operations where \
         a product and the addition that it joins are one.",
    ),
    (
        "counts",
        "Instructions",
        "Instructions a call on x86-64-v3, its loop included, counted by callgrind, and the limits \
         that they are held to.",
    ),
    (
        "limits",
        "Batches and the machine",
        "Batches of `ga-lanes`, structures of arrays, with the instructions found at run time. \
         In cache the share is that of the machine's multiply-adds, out of cache that of a copy.",
    ),
    (
        "dense",
        "Dense products",
        "Products of multivectors with all coefficients stored.",
    ),
    (
        "expand",
        "Expansion and compilation",
        "What the generator makes of a declaration, and what it costs.",
    ),
];

fn main() -> ExitCode {
    let mut page = String::from("# Measurements\n\n");
    let _ = writeln!(page, "Written by `cargo bench --bench results`.\n");
    page += &machine::description();
    let mut failed = Vec::new();
    for (bench, heading, note) in SECTIONS {
        eprintln!("{bench} …");
        let _ = write!(
            page,
            "\n## {heading}\n\n{note} `cargo bench --bench {bench}`\n\n"
        );
        match output(bench) {
            Ok(text) => {
                let _ = write!(page, "```text\n{}\n```\n", text.trim_end());
            }
            Err((text, problem)) => {
                failed.push(bench);
                let _ = write!(
                    page,
                    "```text\n{}\n\n{}\n```\n",
                    text.trim_end(),
                    problem.trim()
                );
            }
        }
    }
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("RESULTS.md");
    if let Err(error) = std::fs::write(&path, page) {
        eprintln!("{}: {error}", path.display());
        return ExitCode::FAILURE;
    }
    println!("wrote {}", path.display());
    match failed.is_empty() {
        true => ExitCode::SUCCESS,
        false => {
            eprintln!("failed, and told so on the page: {}", failed.join(", "));
            ExitCode::FAILURE
        }
    }
}

/// What a bench prints; what it prints and what is wrong, where it fails.
fn output(bench: &str) -> Result<String, (String, String)> {
    let package = Path::new(env!("CARGO_MANIFEST_DIR"));
    let output = Command::new(env!("CARGO"))
        .args(["bench", "--quiet", "--bench", bench])
        .current_dir(package.parent().unwrap_or(package))
        .output()
        .map_err(|error| (String::new(), format!("cargo does not run: {error}")))?;
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    match output.status.success() {
        true => Ok(text),
        false => Err((text, String::from_utf8_lossy(&output.stderr).into_owned())),
    }
}
