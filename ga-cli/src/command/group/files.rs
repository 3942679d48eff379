//! Decides which files a group can be saved in: surfaces, drawings of lines, and the JSON document.

mod drawing;

use super::{Arguments, Made};
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
    Surface(Format),
    Lines,
    Json,
}

/// The ending of a file names no form in which a group can be saved.
#[derive(Debug, Error)]
#[error(
    "a group cannot be saved under this ending; use one of .glb .obj .stl .ply .png .svg .json"
)]
pub struct UnknownEnding;

impl Destination {
    /// The file at this path, in the form of its ending.
    ///
    /// # Errors
    /// [`UnknownEnding`], which lists the endings that there are.
    pub fn new(path: PathBuf) -> Result<Self, UnknownEnding> {
        let ending = path.extension().unwrap_or_default();
        let form = match Format::from_path(&path) {
            _ if ending.eq_ignore_ascii_case("json") => Form::Json,
            Ok(Format::Svg) => Form::Lines,
            Ok(format) => Form::Surface(format),
            Err(_) => return Err(UnknownEnding),
        };
        Ok(Self { path, form })
    }
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
