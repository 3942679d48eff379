//! How many operations the generated functions take, beside the fewest that are known elsewhere:
//! `cargo bench --bench operations` prints a row for each, from the ledgers of the algebras.

use std::process::ExitCode;

use ga_benches::declarations;
use ga_codegen::Ledger;

/// Functions that together do what the first column names, and the goal for their multiplications.
struct Row {
    what: &'static str,
    functions: &'static [&'static str],
    goal: usize,
}

const fn row(what: &'static str, functions: &'static [&'static str], goal: usize) -> Row {
    Row {
        what,
        functions,
        goal,
    }
}

const SPACE: [Row; 2] = [
    row("rotor on vector", &["Unit<Even>.apply(Vector)"], 15),
    row("rotor·rotor", &["Even.geometric(Even)"], 16),
];

const PLANE_BASED: [Row; 4] = [
    row("motor on point", &["Unit<Motor>.apply(Point)"], 18),
    row("motor on plane", &["Unit<Motor>.apply(Plane)"], 28),
    row("motor on line", &["Unit<Motor>.apply(Line)"], 45),
    row("motor·motor", &["Motor.geometric(Motor)"], 48),
];

const CONFORMAL: [Row; 9] = [
    row("motor on null point", &["Unit<Motor>.apply(Point)"], 25),
    row("motor on vector", &["Unit<Motor>.apply(DualSphere)"], 36),
    row("motor on line", &["Unit<Motor>.apply(Line)"], 45),
    row("motor on circle", &["Unit<Motor>.apply(Circle)"], 107),
    row("versor on vector", &["Unit<Even>.apply(DualSphere)"], 115),
    row("versor on null point", &["Unit<Even>.apply(Point)"], 60),
    row("motor·motor", &["Motor.geometric(Motor)"], 48),
    row(
        "p∧q∧r",
        &["Point.wedge(Point)", "Point.wedge(PointPair)"],
        50,
    ),
    row(
        "sphere of four points",
        &[
            "Point.wedge(Point)",
            "Point.wedge(PointPair)",
            "Point.wedge(Circle)",
        ],
        70,
    ),
];

/// Points of weight 1 that are not promised to be null.
const CONFORMAL_NOT_NULL: [Row; 1] = [row(
    "motor on point, n_o = 1",
    &["Unit<Motor>.apply(Point)"],
    32,
)];

fn main() -> ExitCode {
    println!(
        "{:<28} {:<24} {:>15} {:>6} {:>9} {:>6}",
        "algebra", "operation", "multiplications", "asked", "additions", "fused"
    );
    let conformal = declarations::conformal().to_owned();
    let tables: [(&str, String, &[Row]); 4] = [
        ("R3", "R3".to_owned(), &SPACE),
        (
            "plane-based",
            declarations::plane_based().to_owned(),
            &PLANE_BASED,
        ),
        ("conformal", conformal.clone(), &CONFORMAL),
        (
            "conformal without #[null]",
            conformal.replace("#[null]", ""),
            &CONFORMAL_NOT_NULL,
        ),
    ];
    for (algebra, declaration, rows) in &tables {
        if let Err(problem) = print(algebra, declaration, rows) {
            eprintln!("{algebra}: {problem}");
            return ExitCode::FAILURE;
        }
    }
    ExitCode::SUCCESS
}

/// Prints the rows of one algebra.
fn print(algebra: &str, declaration: &str, rows: &[Row]) -> Result<(), String> {
    let ledger = ga_codegen::ledger(declaration).map_err(|mistakes| mistakes.to_string())?;
    for row in rows {
        let [multiplications, additions, fused] = total(&ledger, row.functions)?;
        let verdict = if multiplications <= row.goal {
            "reached"
        } else {
            "MISSED"
        };
        println!(
            "{algebra:<28} {:<24} {multiplications:>15} {:>6} {additions:>9} {fused:>6}  {verdict}",
            row.what, row.goal
        );
    }
    Ok(())
}

/// What all functions of a row take together.
fn total(ledger: &Ledger, functions: &[&str]) -> Result<[usize; 3], String> {
    functions.iter().try_fold([0; 3], |sum, function| {
        let mut entries = ledger.entries.iter();
        let entry = entries.find(|entry| entry.function == *function);
        let cost = entry
            .and_then(|entry| entry.cost)
            .ok_or_else(|| format!("the ledger has no count of {function}"))?;
        let [multiplications, additions, fused] = sum;
        Ok([
            multiplications + cost.multiplications,
            additions + cost.additions,
            fused + cost.fused,
        ])
    })
}
