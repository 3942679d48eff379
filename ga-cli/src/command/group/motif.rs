//! Decides what is repeated: a shape that the program brings along, a surface from a file, or atoms.

pub(super) use super::request::short;
use crate::failure::Failure;
use ga_design::crystallography::AsymmetricMotif;
use ga_design::crystallography::asymmetric::{comma_outline, flat_comma};
use ga_design::mesh::{Mesh, MeshError};
use std::path::Path;

mod file;

/// A motif that fits into the unit ball about the origin.
pub struct MotifShape {
    /// Its name, or that of its file.
    pub name: String,
    /// What it consists of.
    pub parts: Vec<Part>,
}

/// A piece of one colour.
pub struct Part {
    /// The name of its node.
    pub name: String,
    /// The surface.
    pub mesh: Mesh,
    /// Lines for drawings.
    pub lines: Vec<Outline>,
    /// Its colour; without one, that of the hand of the copy.
    pub colour: Option<[u8; 3]>,
    /// How much of what is behind it it hides, from 0 to 1.
    pub opacity: f64,
    /// The middle of a sphere, which has no corners by which copies could be compared.
    pub centre: Option<[f64; 3]>,
}

/// A line of a drawing.
#[derive(Clone)]
pub struct Outline {
    /// Its points.
    pub points: Vec<[f64; 3]>,
    /// Whether it is closed, and filled in drawings of the plane.
    pub is_area: bool,
}

/// The motif of a name or file; without one the comma for the plane and the hand for space.
pub fn find(text: Option<&str>, is_flat: bool) -> Result<MotifShape, Failure> {
    let usual = if is_flat { "comma" } else { "hand" };
    let text = text.unwrap_or(usual);
    if let Some(motif) = AsymmetricMotif::from_name(text) {
        return brought(motif, is_flat).map_err(|reason| Failure::Usage(reason.to_string()));
    }
    let path = Path::new(text);
    let ending = path.extension().unwrap_or_default().to_ascii_lowercase();
    match ending.to_str() {
        Some("obj") => file::obj(path),
        Some("stl") => file::stl(path),
        Some("xyz") => file::atoms(path),
        _ if path.is_dir() => Err(Failure::Usage(format!(
            "--motif {}: this is a directory; give a file .obj, .stl or .xyz in it",
            short(text)
        ))),
        _ => Err(Failure::Usage(format!(
            "--motif {}: no such motif; give one of {}, or a file .obj, .stl or .xyz",
            short(text),
            AsymmetricMotif::ALL.map(AsymmetricMotif::name).join(", ")
        ))),
    }
}

fn brought(motif: AsymmetricMotif, is_flat: bool) -> Result<MotifShape, MeshError> {
    let (mesh, lines) = if is_flat && motif == AsymmetricMotif::Comma {
        let outline = comma_outline();
        let points = outline.iter().map(|[x, y]| [*x, *y, 0.0]).collect();
        let area = Outline {
            points,
            is_area: true,
        };
        (flat_comma()?, vec![area])
    } else {
        let lines = motif.lines().into_iter().map(|points| Outline {
            points,
            is_area: false,
        });
        (motif.mesh()?, lines.collect())
    };
    Ok(MotifShape {
        name: motif.name().to_owned(),
        parts: vec![Part {
            name: motif.name().to_owned(),
            mesh,
            lines,
            colour: None,
            opacity: 1.0,
            centre: None,
        }],
    })
}
