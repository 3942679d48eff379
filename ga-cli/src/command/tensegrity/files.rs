//! Decides which files a structure can be saved in: all that hold surfaces, its lines as a drawing, and
//! the JSON document.

use super::document::Document;
use crate::destination::{Destination, Forms};
use crate::failure::Failure;
use crate::output;
use ga_design::export::{Format, encode};
use ga_design::tensegrity::{Structure, scene};
use std::path::PathBuf;

/// A form in which a structure is saved.
#[derive(Debug, Clone, Copy)]
pub enum Form {
    /// A model or a picture.
    Drawn(Format),
    /// The document.
    Json,
}

impl Forms for Form {
    const SUBJECT: &'static str = "a structure";
    const ENDINGS: &'static [(&'static str, Self)] = &[
        ("glb", Self::Drawn(Format::Glb)),
        ("obj", Self::Drawn(Format::Obj)),
        ("stl", Self::Drawn(Format::Stl)),
        ("ply", Self::Drawn(Format::Ply)),
        ("png", Self::Drawn(Format::Png)),
        ("svg", Self::Drawn(Format::Svg)),
        ("json", Self::Json),
    ];
}

impl Destination<Form> {
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
pub fn written(files: &[Destination<Form>], document: &Document) -> String {
    let lines = files
        .iter()
        .map(|file| format!("{}: {}\n", file.path.display(), document.caption()));
    lines.collect()
}
