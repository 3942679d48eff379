//! Tables in JSON: what is read, and what is said of a file that is none.

use ga_cga::Motor;
use serde_json::{Map, Value};
use thiserror::Error;

use super::{Convention, Row, Table};
use crate::linkages::{Frame, Limits};

/// How far a matrix of a base or tool may be from a rigid motion.
const RIGIDITY: f64 = 1e-6;

/// Why a text is no table.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum TableError {
    /// It is not JSON.
    #[error("no JSON: {0}")]
    Json(String),
    /// Something is missing or of another kind.
    #[error("{place} {problem}")]
    Wrong {
        /// Where it is, as `rows[2].alpha`.
        place: String,
        /// What is wrong there, and what would be right.
        problem: String,
    },
}

impl Table {
    /// Reads a table with its name:
    /// `{name, convention: "standard"|"modified", rows: [{joint: "R"|"P", theta, d, a, alpha,
    /// offset, flip, qlim: [lower, upper]}], base, tool}`. Angles are in radians, `base` and `tool`
    /// matrices of four rows. Numbers left out of a row are 0, limits left out none, matrices left
    /// out the identity.
    ///
    /// # Errors
    /// [`TableError`], which names the place.
    pub fn from_json(text: &str) -> Result<(String, Table), TableError> {
        let value: Value =
            serde_json::from_str(text).map_err(|error| TableError::Json(error.to_string()))?;
        let table = object(&value, "the table")?;
        let rows = table.get("rows").and_then(Value::as_array);
        let rows = rows.ok_or_else(|| wrong("rows", "is missing; write a list of rows"))?;
        if rows.is_empty() {
            return Err(wrong("rows", "is empty; an arm has at least one row"));
        }
        let row = |(number, value): (usize, &Value)| row(value, &format!("rows[{number}]"));
        let rows: Result<Vec<Row>, TableError> = rows.iter().enumerate().map(row).collect();
        let rows = rows?;
        let name = table.get("name").and_then(Value::as_str);
        Ok((
            name.unwrap_or("arm").to_owned(),
            Table {
                convention: convention(table.get("convention"))?,
                rows,
                base: motion(table, "base")?,
                tool: motion(table, "tool")?.motor(),
            },
        ))
    }
}

fn wrong(place: impl Into<String>, problem: impl Into<String>) -> TableError {
    TableError::Wrong {
        place: place.into(),
        problem: problem.into(),
    }
}

fn object<'a>(value: &'a Value, place: &str) -> Result<&'a Map<String, Value>, TableError> {
    let object = value.as_object();
    object.ok_or_else(|| wrong(place, "is no object; write it in braces"))
}

fn convention(value: Option<&Value>) -> Result<Convention, TableError> {
    match value.and_then(Value::as_str) {
        Some("standard" | "standard_dh") => Ok(Convention::Standard),
        Some("modified" | "modified_dh") => Ok(Convention::Modified),
        Some(other) => Err(wrong(
            "convention",
            format!("is \"{other}\"; write \"standard\" or \"modified\""),
        )),
        None => Err(wrong(
            "convention",
            "is missing; write \"standard\" (Denavit–Hartenberg) or \"modified\" (Craig)",
        )),
    }
}

fn row(value: &Value, place: &str) -> Result<Row, TableError> {
    let row = object(value, place)?;
    let number = |name: &str| match row.get(name) {
        None => Ok(0.0),
        Some(value) => finite(value, &format!("{place}.{name}")),
    };
    let is_prismatic = match row.get("joint").and_then(Value::as_str) {
        Some("R") => false,
        Some("P") => true,
        _ => {
            return Err(wrong(
                format!("{place}.joint"),
                "must be \"R\" for a hinge or \"P\" for a slider",
            ));
        }
    };
    let is_flipped = match row.get("flip") {
        None => false,
        Some(value) => value
            .as_bool()
            .ok_or_else(|| wrong(format!("{place}.flip"), "must be true or false"))?,
    };
    Ok(Row {
        is_prismatic,
        theta: number("theta")?,
        d: number("d")?,
        a: number("a")?,
        alpha: number("alpha")?,
        offset: number("offset")?,
        is_flipped,
        limits: limits(row.get("qlim"), &format!("{place}.qlim"))?,
    })
}

fn finite(value: &Value, place: &str) -> Result<f64, TableError> {
    let number = value.as_f64().filter(|number| number.is_finite());
    number.ok_or_else(|| wrong(place, format!("is {value}; write a finite number")))
}

fn limits(value: Option<&Value>, place: &str) -> Result<Limits, TableError> {
    let Some(value) = value.filter(|value| !value.is_null()) else {
        return Ok(Limits::unlimited());
    };
    let Some([lower, upper]) = value.as_array().map(Vec::as_slice) else {
        return Err(wrong(place, "must be two numbers, [least, largest]"));
    };
    let [lower, upper] = [finite(lower, place)?, finite(upper, place)?];
    Limits::new(lower, upper).ok_or_else(|| {
        wrong(
            place,
            format!("goes from {lower} to {upper}; write the lesser number first"),
        )
    })
}

fn motion(table: &Map<String, Value>, place: &str) -> Result<Frame, TableError> {
    let Some(value) = table.get(place).filter(|value| !value.is_null()) else {
        return Ok(Frame::world());
    };
    let shape = || wrong(place, "must be a matrix of four rows of four numbers");
    let rows = value
        .as_array()
        .filter(|rows| rows.len() == 4)
        .ok_or_else(shape)?;
    let mut matrix = [[0.0; 4]; 4];
    for (number, (row, values)) in matrix.iter_mut().zip(rows).enumerate() {
        let values = values
            .as_array()
            .filter(|row| row.len() == 4)
            .ok_or_else(shape)?;
        for (column, (entry, value)) in row.iter_mut().zip(values).enumerate() {
            *entry = finite(value, &format!("{place}[{number}][{column}]"))?;
        }
    }
    let motor = Motor::from_matrix(matrix, RIGIDITY)
        .map_err(|error| wrong(place, format!("is no rigid motion: {error}")))?;
    Frame::new(motor).ok_or_else(|| wrong(place, "has numbers too large to compute with"))
}
