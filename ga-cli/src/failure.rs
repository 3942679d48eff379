//! Decides how a command can fail and what is said then: one message, which names the file, the line
//! where there is one, and the remedy.

use ga_design::crystallography::cif::CifError;
use ga_design::crystallography::overlay::OverlayError;
use ga_design::crystallography::{BondError, CellRangeError, ExpansionError};
use ga_design::export::ExportError;
use ga_design::gallery::GalleryError;
use ga_design::tensegrity::TensegrityError;
use std::io::{self, Write};
use std::path::PathBuf;
use std::process::ExitCode;
use thiserror::Error;

/// Why a command did not do what it was asked for.
#[derive(Debug, Error)]
pub enum Failure {
    /// A crystal's file cannot be read; the message names file, line and remedy.
    #[error(transparent)]
    Cif(#[from] CifError),
    /// A crystal cannot be built.
    #[error("{}: {reason}", file.display())]
    Expansion {
        /// The crystal's file.
        file: PathBuf,
        /// What stands in the way.
        reason: ExpansionError,
    },
    /// The bonds of a crystal cannot be found.
    #[error("{}: {reason} (--no-bonds)", file.display())]
    Bonds {
        /// The crystal's file.
        file: PathBuf,
        /// What stands in the way.
        reason: BondError,
    },
    /// More cells are asked for than any program could build.
    #[error("{}: --cells: {reason}; ask for fewer cells (such as 2x2x2)", file.display())]
    Cells {
        /// The crystal's file.
        file: PathBuf,
        /// What is wrong with them.
        reason: CellRangeError,
    },
    /// The symmetry elements of a crystal cannot be found or drawn.
    #[error("{}: --symmetry: {reason}", file.display())]
    Symmetry {
        /// The crystal's file.
        file: PathBuf,
        /// What stands in the way.
        reason: OverlayError,
    },
    /// A file cannot be made or written; the message names it.
    #[error(transparent)]
    Export(#[from] ExportError),
    /// A file cannot be made of a crystal.
    #[error("{}: {reason}", file.display())]
    Drawing {
        /// The crystal's file, or the one to be made.
        file: PathBuf,
        /// What stands in the way.
        reason: ExportError,
    },
    /// A scene of the gallery cannot be made.
    #[error("the scene `{scene}` cannot be made: {reason}")]
    Scene {
        /// The name of the scene.
        scene: &'static str,
        /// What stands in the way.
        reason: GalleryError,
    },
    /// A structure of struts and cables cannot be made.
    #[error(transparent)]
    Tensegrity(#[from] TensegrityError),
    /// The command line asks for what there is not, in a way that only the command can tell; the message
    /// says what there is.
    #[error("{0}")]
    Usage(String),
    /// A motif cannot be read from its file.
    #[error("{}: {message}", file.display())]
    Motif {
        /// The file.
        file: PathBuf,
        /// What is wrong, with its line where there is one.
        message: String,
    },
    /// A robot, its joint values or its targets mean nothing.
    #[error("{}: {problem}", file.display())]
    Arm {
        /// The file.
        file: PathBuf,
        /// What is wrong there, and what would be right.
        problem: String,
    },
    /// An algebra has mistakes, each on a line of its own that begins with its place.
    #[error("{0}")]
    Algebra(String),
    /// A text file cannot be read.
    #[error("{}: cannot be read: {reason}; {remedy}", file.display())]
    Unreadable {
        /// The file.
        file: PathBuf,
        /// What the system said.
        reason: io::Error,
        /// What would help.
        remedy: &'static str,
    },
    /// Standard output refuses what is printed.
    #[error("cannot write to standard output: {0}; check where it leads to")]
    Output(io::Error),
    /// Whoever read standard output has stopped reading; nothing is wrong.
    #[error("standard output is closed")]
    Closed,
    /// A result cannot be written as JSON.
    #[error("cannot write the result as JSON: {0}")]
    Json(#[from] serde_json::Error),
}

impl Failure {
    /// Prints the message and gives the exit code.
    pub fn report(&self) -> ExitCode {
        if matches!(self, Failure::Closed) {
            return ExitCode::SUCCESS;
        }
        // Where standard error is closed too, the exit code alone must tell.
        let _ = writeln!(io::stderr(), "error: {}", self.to_string().trim_end());
        match self {
            Failure::Usage(_) => ExitCode::from(2),
            _ => ExitCode::FAILURE,
        }
    }
}
