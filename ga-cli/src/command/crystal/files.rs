//! Decides which files a crystal can be saved in: those that hold surfaces, lists of atoms, and the
//! JSON document.

use super::Block;
use super::document::Document;
use crate::destination::{Destination, Forms};
use crate::failure::Failure;
use crate::output;
use ga_design::crystallography::{CellRange, cif, xyz};
use ga_design::export::{Format, Scene, encode};
use std::path::PathBuf;

/// A form in which a crystal is saved. Only lines can be drawn with a pen, and a crystal has none.
#[derive(Debug, Clone, Copy)]
pub enum Form {
    /// A model or a picture.
    Drawn(Format),
    /// A list of atoms.
    Xyz,
    /// A crystal file.
    Cif,
    /// The document.
    Json,
}

impl Forms for Form {
    const SUBJECT: &'static str = "a crystal";
    const ENDINGS: &'static [(&'static str, Self)] = &[
        ("glb", Self::Drawn(Format::Glb)),
        ("obj", Self::Drawn(Format::Obj)),
        ("stl", Self::Drawn(Format::Stl)),
        ("ply", Self::Drawn(Format::Ply)),
        ("png", Self::Drawn(Format::Png)),
        ("xyz", Self::Xyz),
        ("extxyz", Self::Xyz),
        ("cif", Self::Cif),
        ("json", Self::Json),
    ];
}

impl Destination<Form> {
    /// Whether the file holds a picture or a model, so that a scene must be made.
    pub fn is_drawn(&self) -> bool {
        matches!(self.form, Form::Drawn(_))
    }

    /// The files that saving the crystal here writes, not yet written.
    pub(super) fn contents(
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
pub fn written(files: &[Destination<Form>], atoms: usize) -> String {
    let plural = if atoms == 1 { "atom" } else { "atoms" };
    let lines = files
        .iter()
        .map(|file| format!("{}: {atoms} {plural}\n", file.path.display()));
    lines.collect()
}
