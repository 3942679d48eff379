//! Decides which files a structure can be saved in: all that hold surfaces, its lines as a drawing, and
//! the JSON document.

use super::document::Document;
use crate::failure::Failure;
use crate::output;
use ga_design::export::{Format, encode};
use ga_design::tensegrity::{Structure, scene};
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

/// The ending of a file names no form in which a structure can be saved.
#[derive(Debug, Error)]
#[error(
    "a structure cannot be saved under this ending; use one of .glb .obj .stl .ply .png .svg .json"
)]
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
        let form = if is_json {
            Form::Json
        } else {
            Form::Drawn(Format::from_path(&path).map_err(|_| UnknownEnding)?)
        };
        Ok(Self { path, form })
    }

    /// The files that saving the structure here writes, not yet written.
    pub fn contents(
        &self,
        structure: &Structure,
        document: &Document,
    ) -> Result<Vec<(PathBuf, Vec<u8>)>, Failure> {
        let format = match self.form {
            Form::Drawn(format) => format,
            Form::Json => {
                let text = output::json(document)?;
                return Ok(vec![(self.path.clone(), text.into_bytes())]);
            }
        };
        // A pen draws lines, everything else shows rods.
        let make = match format {
            Format::Svg => scene::line_scene,
            _ => scene::scene,
        };
        let name = document.shape.replace(' ', "-");
        let scene = make(&name, &document.shape, &document.caption(), structure)?;
        Ok(encode(&scene, format, &self.path)?)
    }
}

/// What is told about the files once they are there.
pub fn written(files: &[Destination], document: &Document) -> String {
    let lines = files
        .iter()
        .map(|file| format!("{}: {}\n", file.path.display(), document.caption()));
    lines.collect()
}
