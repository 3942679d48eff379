//! Decides how poses and solutions are told: as JSON, as CSV, and to people.

use std::path::PathBuf;
use std::time::Duration;

use super::{Common, write_files};
use crate::destination::Forms;
use crate::failure::Failure;
use crate::output;
use ga_design::linkages::{Chain, Frame, Solution};
use serde::Serialize;

/// A form in which results are saved.
#[derive(Debug, Clone, Copy)]
pub enum Form {
    /// A row for each result.
    Csv,
    /// What --json prints.
    Json,
}

impl Forms for Form {
    const SUBJECT: &'static str = "a table of an arm";
    const ENDINGS: &'static [(&'static str, Self)] = &[("csv", Self::Csv), ("json", Self::Json)];
}

/// A pose; fields may be added, never renamed.
#[derive(Debug, Serialize)]
pub struct PoseRow {
    position: [f64; 3],
    quaternion: [f64; 4],
}

/// Joint values for a target; fields may be added, never renamed.
#[derive(Debug, Serialize)]
pub struct SolutionRow {
    joints: Vec<f64>,
    converged: bool,
    position_error: f64,
    rotation_error: f64,
    iterations: usize,
    tries: usize,
    micros: f64,
}

impl PoseRow {
    pub fn new(pose: Frame) -> Self {
        PoseRow {
            position: pose.origin().position().to_array(),
            quaternion: pose.quaternion(),
        }
    }
}

impl SolutionRow {
    pub fn new(solution: Solution, time: Duration) -> Self {
        SolutionRow {
            joints: solution.values,
            converged: solution.converged,
            position_error: solution.miss.position,
            rotation_error: solution.miss.rotation,
            iterations: solution.iterations,
            tries: solution.tries,
            micros: time.as_secs_f64() * 1e6,
        }
    }
}

/// The columns of poses.
pub fn poses_table(rows: &[PoseRow], _: &Chain) -> Vec<Vec<String>> {
    let mut table = vec![
        ["x", "y", "z", "qw", "qx", "qy", "qz"]
            .map(str::to_owned)
            .to_vec(),
    ];
    table.extend(rows.iter().map(|row| {
        let numbers = row.position.iter().chain(&row.quaternion);
        numbers.map(f64::to_string).collect()
    }));
    table
}

/// The columns of solutions: the joints by their names, then how near they come.
pub fn solutions_table(rows: &[SolutionRow], chain: &Chain) -> Vec<Vec<String>> {
    let mut heading: Vec<String> = chain
        .values()
        .iter()
        .map(|joint| joint.name.clone())
        .collect();
    heading.extend(["converged", "position_error", "rotation_error"].map(str::to_owned));
    let mut table = vec![heading];
    table.extend(rows.iter().map(|row| {
        let mut cells: Vec<String> = row.joints.iter().map(f64::to_string).collect();
        cells.push(row.converged.to_string());
        cells.extend([row.position_error, row.rotation_error].map(|error| format!("{error:e}")));
        cells
    }));
    table
}

impl Common {
    /// Saves and prints what was asked for.
    pub fn tell<R: Serialize>(
        &self,
        rows: &[R],
        chain: &Chain,
        table: impl Fn(&[R], &Chain) -> Vec<Vec<String>>,
    ) -> Result<(), Failure> {
        let mut contents: Vec<(PathBuf, Vec<u8>)> = Vec::new();
        for destination in &self.out {
            let bytes = match destination.form {
                Form::Json => output::json(&rows)?.into_bytes(),
                Form::Csv => csv(&table(rows, chain)).into_bytes(),
            };
            contents.push((destination.path.clone(), bytes));
        }
        if !contents.is_empty() {
            write_files(&contents)?;
        }
        if self.json {
            output::print_json(&rows)
        } else if self.out.is_empty() {
            output::print(&output::table(&table(rows, chain)))
        } else {
            let lines = self.out.iter().map(|file| {
                format!(
                    "{}: {} rows of {}\n",
                    file.path.display(),
                    rows.len(),
                    chain.name()
                )
            });
            output::print(&lines.collect::<String>())
        }
    }
}

/// A table as comma-separated values.
fn csv(table: &[Vec<String>]) -> String {
    let quoted = |cell: &String| match cell.contains([',', '"', '\n', '\r']) {
        true => format!("\"{}\"", cell.replace('"', "\"\"")),
        false => cell.clone(),
    };
    let line = |row: &Vec<String>| row.iter().map(quoted).collect::<Vec<_>>().join(",") + "\n";
    table.iter().map(line).collect()
}
