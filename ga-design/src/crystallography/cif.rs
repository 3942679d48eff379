//! How a CIF file becomes a [`Crystal`]: tokens → blocks → cell, symmetry, sites.
//!
//! The format is CIF 1.1 (S. R. Hall, F. H. Allen and I. D. Brown, *Acta Cryst.* A47 (1991)
//! 655–685; *International Tables* G), read tolerantly: what a reader can pass over without
//! changing the crystal is a [`Warning`], what it cannot is a [`CifError`] that names file, line
//! and remedy. Dots in data names (as in macromolecular files) count as underscores.

use std::fmt;
use std::io::{ErrorKind, Read};
use std::path::Path;

use super::crystal::Crystal;

mod block;
mod extract;
mod number;
mod problem;
mod sites;
mod symmetry;
mod token;
mod write;

pub use problem::Problem;
pub use write::{write, write_block};

/// The largest file that is read, in bytes.
pub const LARGEST_FILE: usize = 128 << 20;

/// A crystal read from a file, and what was passed over on the way.
#[derive(Clone, Debug, PartialEq)]
pub struct Reading {
    /// The crystal.
    pub crystal: Crystal,
    /// What looked wrong but did not stand in the way, in the order of finding; at most 100.
    pub warnings: Vec<Warning>,
}

/// Something in a file that looks wrong but can be passed over.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Warning {
    /// The line, counted from 1.
    pub line: usize,
    /// What was found, and what was made of it.
    pub message: String,
}

impl fmt::Display for Warning {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(out, "line {}: {}", self.line, self.message)
    }
}

/// Why a file gives no crystal: one line of text `file:line: what is wrong; what would be right`.
#[derive(Clone, Debug, PartialEq)]
pub struct CifError {
    /// The name of the file as given.
    pub file: String,
    /// The line, counted from 1; `None` when the file could not be opened.
    pub line: Option<usize>,
    /// What is wrong.
    pub problem: Problem,
}

impl fmt::Display for CifError {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(out, "{}:", self.file)?;
        if let Some(line) = self.line {
            write!(out, "{line}:")?;
        }
        write!(out, " {}", one_line(&self.problem.to_string()))
    }
}

impl std::error::Error for CifError {}

/// Reads the first crystal of a file.
///
/// # Errors
/// [`CifError`] when the file cannot be read, is no CIF, is cut off, or holds no complete crystal.
pub fn read_file(path: impl AsRef<Path>) -> Result<Reading, CifError> {
    let path = path.as_ref();
    let file = path.display().to_string();
    let unreadable = |error: std::io::Error| CifError {
        file: file.clone(),
        line: None,
        problem: Problem::Unreadable {
            reason: refusal(&error),
        },
    };
    // One byte more than allowed tells a file that is too large, without reading all of it.
    let limit = LARGEST_FILE as u64 + 1;
    let mut bytes = Vec::new();
    let opened = std::fs::File::open(path).map_err(unreadable)?;
    opened
        .take(limit)
        .read_to_end(&mut bytes)
        .map_err(unreadable)?;
    read_bytes(&file, &bytes)
}

/// Why the operating system refused to read a file, and what would be right.
fn refusal(error: &std::io::Error) -> String {
    match error.kind() {
        ErrorKind::NotFound => String::from("there is no such file; check the path"),
        ErrorKind::IsADirectory => String::from("it is a directory; name a file in it"),
        ErrorKind::PermissionDenied => String::from("you may not read it; change its permissions"),
        _ => error.to_string(),
    }
}

/// Reads the first crystal of a file already in memory; `file` is its name for messages.
///
/// A byte order mark is passed over, bytes that are no UTF-8 are replaced.
///
/// # Errors
/// As [`read_file`].
pub fn read_bytes(file: &str, bytes: &[u8]) -> Result<Reading, CifError> {
    let fail = |problem| CifError {
        file: file.to_owned(),
        line: Some(1),
        problem,
    };
    if bytes.len() > LARGEST_FILE {
        return Err(fail(Problem::TooLarge {
            what: "bytes",
            limit: LARGEST_FILE,
        }));
    }
    // No text file has a zero byte; UTF-16 has one in every second place.
    if let Some(at) = bytes.iter().position(|byte| *byte == 0) {
        let line = 1 + bytes.iter().take(at).filter(|byte| **byte == b'\n').count();
        return Err(CifError {
            line: Some(line),
            ..fail(Problem::Binary)
        });
    }
    read_str(file, &String::from_utf8_lossy(bytes))
}

/// Reads the first crystal of a text; `file` is its name for messages.
///
/// # Errors
/// As [`read_file`].
pub fn read_str(file: &str, text: &str) -> Result<Reading, CifError> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let mut warnings = Warnings::default();
    let found = block::blocks(text, &mut warnings)
        .and_then(|blocks| extract::crystal(&blocks, &mut warnings));
    match found {
        Ok(crystal) => Ok(Reading {
            crystal,
            warnings: warnings.list,
        }),
        Err(Located { line, problem }) => Err(CifError {
            file: file.to_owned(),
            line: Some(line),
            problem,
        }),
    }
}

/// A message without the line ends and other control characters that quoted values may hold.
fn one_line(message: &str) -> String {
    message
        .chars()
        .map(|c| if c.is_control() { ' ' } else { c })
        .collect()
}

/// A problem at a line.
#[derive(Debug)]
struct Located {
    line: usize,
    problem: Problem,
}

impl Located {
    fn new(line: usize, problem: Problem) -> Self {
        Self { line, problem }
    }
}

/// Collects warnings, no more than anyone reads.
#[derive(Debug, Default)]
struct Warnings {
    list: Vec<Warning>,
}

impl Warnings {
    fn add(&mut self, line: usize, message: impl Into<String>) {
        if self.list.len() < 100 {
            self.list.push(Warning {
                line,
                message: one_line(&message.into()),
            });
        }
    }
}
