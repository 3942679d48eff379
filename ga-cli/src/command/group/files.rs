//! Decides which files a group can be saved in: surfaces, drawings of lines, and the JSON document.

mod drawing;

use super::{Arguments, Made};
use crate::destination::Forms;
use crate::failure::Failure;
use crate::output;
use ga_design::export::{Format, Scene, encode};
use std::path::PathBuf;

/// A form in which a group is saved.
#[derive(Debug, Clone, Copy)]
pub enum Form {
    /// A model or a picture.
    Surface(Format),
    /// A drawing.
    Lines,
    /// The document.
    Json,
}

impl Forms for Form {
    const SUBJECT: &'static str = "a group";
    const ENDINGS: &'static [(&'static str, Self)] = &[
        ("glb", Self::Surface(Format::Glb)),
        ("obj", Self::Surface(Format::Obj)),
        ("stl", Self::Surface(Format::Stl)),
        ("ply", Self::Surface(Format::Ply)),
        ("png", Self::Surface(Format::Png)),
        ("svg", Self::Lines),
        ("json", Self::Json),
    ];
}

/// The contents of all files that were asked for, not yet written.
pub fn contents(arguments: &Arguments, made: &Made) -> Result<Vec<(PathBuf, Vec<u8>)>, Failure> {
    let mut contents = Vec::new();
    let mut surfaces: Option<Scene> = None;
    for destination in &arguments.out {
        let path = &destination.path;
        let Some(drawing) = &made.drawing else {
            break;
        };
        match destination.form {
            Form::Json => {
                contents.push((path.clone(), output::json(&made.document)?.into_bytes()));
            }
            Form::Lines => contents.push((path.clone(), drawing::svg(drawing)?.into_bytes())),
            Form::Surface(format) => {
                let scene = match surfaces.take() {
                    Some(scene) => scene,
                    None => drawing.scene()?,
                };
                contents.extend(encode(&scene, format, path)?);
                surfaces = Some(scene);
            }
        }
    }
    Ok(contents)
}

/// What is told about the files once they are there.
pub fn written(arguments: &Arguments, made: &Made) -> String {
    let told = made.drawing.as_ref().map(super::scene::Drawing::place);
    let lines = arguments.out.iter().map(|file| {
        let path = file.path.display();
        match (&told, file.form) {
            (Some(motif), Form::Surface(_) | Form::Lines) => {
                let plural = if motif.copies == 1 { "copy" } else { "copies" };
                format!("{path}: {}, {} {plural}\n", motif.name, motif.copies)
            }
            _ => format!("{path}: the group as JSON\n"),
        }
    });
    lines.collect()
}
