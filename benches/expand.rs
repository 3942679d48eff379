//! What the generator costs: tokens, functions and time per algebra, and the compilation of the
//! conformal model. `cargo bench --bench expand` prints one line each.

use std::path::Path;
use std::process::Command;
use std::time::Instant;

use ga_benches::declarations;

/// The budgets that the project holds itself to.
const TOKEN_BUDGET: usize = 500_000;
const SECONDS_BUDGET: f64 = 15.0;

fn main() {
    println!(
        "{:<24} {:>9} {:>9} {:>9}",
        "algebra", "tokens", "functions", "ms"
    );
    for preset in ["R2", "R3", "R2_0_1", "R3_0_1", "R1_3", "R4_1", "R3_3", "R6"] {
        report(preset, preset);
    }
    let tokens = report("conformal (ga-cga)", declarations::conformal());
    println!("conformal expansion: {tokens} tokens, budget {TOKEN_BUDGET}");
    match compile_seconds() {
        Ok(seconds) => println!(
            "cargo build -p ga-cga beyond its dependencies: {seconds:.1} s CPU, budget \
             {SECONDS_BUDGET} s"
        ),
        Err(reason) => println!("cargo build -p ga-cga: not measured, {reason}"),
    }
}

/// Prints the cost of one expansion, the fastest of three, and returns its tokens.
fn report(name: &str, declaration: &str) -> usize {
    let mut best = f64::INFINITY;
    let mut ledger = ga_codegen::Ledger::default();
    for _ in 0..3 {
        let start = Instant::now();
        match ga_codegen::ledger(declaration) {
            Ok(result) => ledger = result,
            Err(mistakes) => {
                println!("{name}: {mistakes}");
                return 0;
            }
        }
        best = best.min(start.elapsed().as_secs_f64() * 1e3);
    }
    println!(
        "{name:<24} {:>9} {:>9} {best:>9.1}",
        ledger.tokens,
        ledger.entries.len()
    );
    ledger.tokens
}

/// CPU seconds of compiling ga-cga alone, its dependencies built before.
fn compile_seconds() -> Result<f64, String> {
    let root = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/.."));
    let cargo = |arguments: &[&str]| {
        let status = Command::new(env!("CARGO"))
            .args(arguments)
            .args(["--quiet", "--target-dir"])
            .arg(root.join("target/expand"))
            .current_dir(root)
            .status()
            .map_err(|error| format!("cargo does not run: {error}"))?;
        status
            .success()
            .then_some(())
            .ok_or_else(|| "cargo failed".to_owned())
    };
    cargo(&["build", "-p", "ga-cga"])?;
    cargo(&["clean", "-p", "ga-cga"])?;
    let before = children_seconds()?;
    cargo(&["build", "-p", "ga-cga"])?;
    Ok(children_seconds()? - before)
}

/// User and system time of all finished child processes, from Linux's process table.
fn children_seconds() -> Result<f64, String> {
    let stat = std::fs::read_to_string("/proc/self/stat")
        .map_err(|_| "it is measured on Linux only".to_owned())?;
    let fields: Vec<&str> = stat
        .rsplit_once(')')
        .map_or("", |(_, rest)| rest)
        .split_whitespace()
        .collect();
    let ticks = |position: usize| fields.get(position).and_then(|f| f.parse::<f64>().ok());
    // cutime and cstime; a tick is a hundredth of a second on every Linux in use.
    match (ticks(13), ticks(14)) {
        (Some(user), Some(system)) => Ok((user + system) / 100.0),
        _ => Err("the process table reads differently here".to_owned()),
    }
}
