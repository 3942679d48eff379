//! Decides which files a crystal can be saved in: those that hold surfaces, and the JSON document.

use super::document::Document;
use crate::failure::Failure;
use crate::output;
use ga_design::export::{Format, Scene, encode};
use std::path::PathBuf;
use thiserror::Error;

/// A file to be saved.
#[derive(Debug, Clone)]
pub struct Destination {
    /// Where.
    pub path: PathBuf,
    form: Form,
}

#[derive(Debug, Clone, Copy)]
enum Form {
    Drawn(Format),
    Json,
}

/// The ending of a file names no form in which a crystal can be saved.
#[derive(Debug, Error)]
#[error("a crystal cannot be saved under this ending; use one of .glb .obj .stl .ply .png .json")]
pub struct UnknownEnding;

impl Destination {
    /// The file at this path, in the form of its ending.
    ///
    /// # Errors
    /// [`UnknownEnding`], which lists the endings that there are.
    pub fn new(path: PathBuf) -> Result<Self, UnknownEnding> {
        let is_json = path
            .extension()
            .is_some_and(|ending| ending.eq_ignore_ascii_case("json"));
        let form = match Format::from_path(&path) {
            _ if is_json => Form::Json,
            // Only lines can be drawn with a pen, and a crystal has none.
            Ok(Format::Svg) | Err(_) => return Err(UnknownEnding),
            Ok(format) => Form::Drawn(format),
        };
        Ok(Self { path, form })
    }

    /// The files that saving the crystal here writes, not yet written.
    pub fn contents(
        &self,
        scene: &Scene,
        document: &Document,
    ) -> Result<Vec<(PathBuf, Vec<u8>)>, Failure> {
        match self.form {
            Form::Drawn(format) => Ok(encode(scene, format, &self.path)?),
            Form::Json => Ok(vec![(
                self.path.clone(),
                output::json(document)?.into_bytes(),
            )]),
        }
    }
}

/// What is told about the files once they are there.
pub fn written(files: &[Destination], atoms: usize) -> String {
    let plural = if atoms == 1 { "atom" } else { "atoms" };
    let lines = files
        .iter()
        .map(|file| format!("{}: {atoms} {plural}\n", file.path.display()));
    lines.collect()
}
