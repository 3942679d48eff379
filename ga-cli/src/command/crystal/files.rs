//! Decides which files a crystal can be saved in: those that hold surfaces, lists of atoms, and the
//! JSON document.

use super::Block;
use super::document::Document;
use crate::failure::Failure;
use crate::output;
use ga_design::crystallography::{CellRange, cif, xyz};
use ga_design::export::{Format, Scene, encode};
use std::path::{Path, PathBuf};
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
    Xyz,
    Cif,
    Json,
}

impl Form {
    /// The form that an ending asks for, if a crystal has it.
    fn of(path: &Path) -> Option<Self> {
        let ending = path.extension().unwrap_or_default().to_ascii_lowercase();
        match ending.to_str() {
            Some("json") => Some(Self::Json),
            Some("xyz" | "extxyz") => Some(Self::Xyz),
            Some("cif") => Some(Self::Cif),
            // Only lines can be drawn with a pen, and a crystal has none.
            Some("svg") => None,
            _ => Format::from_path(path).ok().map(Self::Drawn),
        }
    }
}

/// The ending of a file names no form in which a crystal can be saved.
#[derive(Debug, Error)]
#[error(
    "a crystal cannot be saved under this ending; use one of .glb .obj .stl .ply .png .xyz .cif .json"
)]
pub struct UnknownEnding;

impl Destination {
    /// The file at this path, in the form of its ending.
    ///
    /// # Errors
    /// [`UnknownEnding`], which lists the endings that there are.
    pub fn new(path: PathBuf) -> Result<Self, UnknownEnding> {
        let form = Form::of(&path).ok_or(UnknownEnding)?;
        Ok(Self { path, form })
    }

    /// Whether the file holds a picture or a model, so that a scene must be made.
    pub fn is_drawn(&self) -> bool {
        matches!(self.form, Form::Drawn(_))
    }

    /// The files that saving the crystal here writes, not yet written.
    pub fn contents(
        &self,
        scene: Option<&Scene>,
        block: &Block<'_>,
        document: &Document,
    ) -> Result<Vec<(PathBuf, Vec<u8>)>, Failure> {
        let Block {
            crystal,
            range,
            atoms,
        } = *block;
        let text = match (self.form, scene) {
            (Form::Drawn(format), Some(scene)) => {
                return encode(scene, format, &self.path).map_err(|reason| Failure::Drawing {
                    file: self.path.clone(),
                    reason,
                });
            }
            // No scene was made for files that are not drawn.
            (Form::Drawn(_), None) => return Ok(Vec::new()),
            (Form::Xyz, _) => xyz::write(&crystal.name, &crystal.cell, range, atoms),
            (Form::Cif, _) if range == CellRange::UNIT => cif::write(crystal),
            (Form::Cif, _) => cif::write_block(crystal, range, atoms),
            (Form::Json, _) => output::json(document)?,
        };
        Ok(vec![(self.path.clone(), text.into_bytes())])
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
