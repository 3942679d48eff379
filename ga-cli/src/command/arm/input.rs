//! Decides what is read as joint values and as targets, from JSON and from CSV.

use std::fmt::Display;
use std::io::ErrorKind;
use std::path::Path;
use std::{fs, io};

use crate::failure::Failure;
use ga_cga::{Point, Rotor};
use ga_design::linkages::{Chain, Frame, Target};
use serde::Deserialize;

/// The text of a file.
pub fn read(file: &Path, remedy: &'static str) -> Result<String, Failure> {
    fs::read_to_string(file).map_err(|reason: io::Error| Failure::Unreadable {
        file: file.to_owned(),
        remedy: match reason.kind() {
            ErrorKind::NotFound => "check its name",
            ErrorKind::IsADirectory | ErrorKind::InvalidData => remedy,
            _ => "check that you may read it",
        },
        reason,
    })
}

/// What is wrong in a file.
pub fn invalid(file: &Path, problem: &dyn Display) -> Failure {
    Failure::Arm {
        file: file.to_owned(),
        problem: problem.to_string(),
    }
}

/// What is wrong in a row of a file, counted from 1.
pub fn wrong_row(file: &Path, row: usize, problem: &dyn Display) -> Failure {
    invalid(file, &format!("row {}: {problem}", row + 1))
}

/// Rows of joint values, as many as the chain takes.
pub fn joint_values(file: &Path, chain: &Chain) -> Result<Vec<Vec<f64>>, Failure> {
    let text = read(file, "give joint values as JSON or CSV")?;
    let rows = match is_json(&text) {
        true => serde_json::from_str(&text).map_err(|error| {
            invalid(
                file,
                &format!("{error}; write a list of lists of numbers, [[q, …], …]"),
            )
        })?,
        false => numbers(file, &text)?,
    };
    let taken = chain.values().len();
    match rows.iter().position(|row| row.len() != taken) {
        Some(row) => Err(wrong_row(
            file,
            row,
            &format!(
                "{} joint values for {}: it takes {taken}",
                rows.get(row).map_or(0, Vec::len),
                chain.name()
            ),
        )),
        None => Ok(rows),
    }
}

/// A target as JSON has it.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Described {
    position: [f64; 3],
    quaternion: Option<[f64; 4]>,
}

/// The targets of a file.
pub fn targets(file: &Path) -> Result<Vec<Target>, Failure> {
    let text = read(file, "give targets as JSON or CSV")?;
    let described: Vec<Described> = match is_json(&text) {
        true => serde_json::from_str(&text).map_err(|error| {
            let form = "[{position: [x, y, z], quaternion: [w, x, y, z]}, …]";
            invalid(file, &format!("{error}; write {form}"))
        })?,
        false => {
            let rows = numbers(file, &text)?.into_iter().enumerate();
            let rows = rows.map(|(number, row)| match *row.as_slice() {
                [x, y, z] => Ok(([x, y, z], None)),
                [x, y, z, w, i, j, k] => Ok(([x, y, z], Some([w, i, j, k]))),
                _ => {
                    let problem =
                        format!("{} numbers; write x,y,z or x,y,z,qw,qx,qy,qz", row.len());
                    Err(wrong_row(file, number, &problem))
                }
            });
            let described = |row: Result<_, Failure>| {
                let (position, quaternion) = row?;
                Ok(Described {
                    position,
                    quaternion,
                })
            };
            rows.map(described).collect::<Result<_, Failure>>()?
        }
    };
    let target = |(row, described): (usize, Described)| {
        target(&described).map_err(|problem| wrong_row(file, row, &problem))
    };
    described.into_iter().enumerate().map(target).collect()
}

/// The target of a row.
fn target(described: &Described) -> Result<Target, &'static str> {
    const RANGE: &str = "a position must be three finite numbers of a size that squares";
    let point = Point::at(
        described.position[0],
        described.position[1],
        described.position[2],
    );
    if !point.to_array().into_iter().all(f64::is_finite) {
        return Err(RANGE);
    }
    let Some(quaternion) = described.quaternion else {
        return Target::position(point).ok_or(RANGE);
    };
    let rotor = Rotor::from_quaternion(quaternion).normalized();
    let rotor = rotor.ok_or("a quaternion must be four finite numbers, not all of them 0")?;
    Frame::at(point, rotor).map(Target::pose).ok_or(RANGE)
}

/// Whether a text is meant to be JSON.
fn is_json(text: &str) -> bool {
    text.trim_start().starts_with(['[', '{'])
}

/// The rows of CSV; a first row without a number is its heading, lines that begin with # are
/// remarks.
fn numbers(file: &Path, text: &str) -> Result<Vec<Vec<f64>>, Failure> {
    let mut reader = csv::ReaderBuilder::new()
        .has_headers(false)
        .flexible(true)
        .comment(Some(b'#'))
        .trim(csv::Trim::All)
        .from_reader(text.as_bytes());
    let mut rows = Vec::new();
    for (number, record) in reader.records().enumerate() {
        let record = record.map_err(|error| invalid(file, &error))?;
        let line = record.position().map_or(0, csv::Position::line);
        let is_heading = number == 0 && record.iter().all(|cell| cell.parse::<f64>().is_err());
        if is_heading {
            continue;
        }
        let cells = record.iter().map(|cell| {
            let number = cell.parse().ok().filter(|number: &f64| number.is_finite());
            number
                .ok_or_else(|| invalid(file, &format!("line {line}: `{cell}` is no finite number")))
        });
        rows.push(cells.collect::<Result<_, Failure>>()?);
    }
    Ok(rows)
}
