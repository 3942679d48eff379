//! Decides how the symmetry elements of a crystal are told in JSON and drawn into its files.

use crate::failure::Failure;
use ga_design::crystallography::overlay::{Shown, add_symmetry_elements, legend};
use ga_design::crystallography::symmetry_elements::{Axis, Fraction, ReflectionPlane};
use ga_design::crystallography::{Cell, CellRange, Crystal, SymmetryElements};
use ga_design::export::Scene;
use serde::Serialize;
use std::path::Path;

/// A symmetry element of one cell, as JSON tells it; numbers in fractions of the edges.
#[derive(Debug, Serialize)]
pub struct SymmetryElement {
    /// rotation, screw, rotoinversion, mirror, glide or inversion.
    pub kind: &'static str,
    /// The symbol of International Tables.
    pub symbol: String,
    /// The direction \[uvw\] of an axis, the indices (hkl) of a plane.
    pub direction: Option<[i64; 3]>,
    /// A point of it.
    pub point: [f64; 3],
    /// The translation of a screw.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub screw: Option<[f64; 3]>,
    /// The translation of a glide.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub glide: Option<[f64; 3]>,
    /// The points that the rotoinversions of an axis leave in place.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub inversion_points: Vec<[f64; 3]>,
}

/// The elements, if they are asked for.
pub fn elements(
    file: &Path,
    crystal: &Crystal,
    asked: bool,
) -> Result<Option<SymmetryElements>, Failure> {
    if !asked {
        return Ok(None);
    }
    let found = SymmetryElements::of(&crystal.operations);
    found.map(Some).map_err(|reason| Failure::Symmetry {
        file: file.to_owned(),
        reason: reason.into(),
    })
}

/// All elements, axes first, then planes and centres.
pub fn described(elements: &SymmetryElements) -> Vec<SymmetryElement> {
    let axes = elements.axes().iter().map(axis);
    let planes = elements.planes().iter().map(plane);
    let centres = elements.centres().iter().map(|centre| SymmetryElement {
        kind: "inversion",
        symbol: String::from("-1"),
        direction: None,
        point: numbers(centre.point()),
        screw: None,
        glide: None,
        inversion_points: Vec::new(),
    });
    axes.chain(planes).chain(centres).collect()
}

/// The caption of a picture with these elements in it.
pub fn caption(caption: String, elements: Option<&SymmetryElements>) -> String {
    match elements {
        Some(elements) => format!("{caption} {}", legend(elements)),
        None => caption,
    }
}

/// Draws the elements, if there are any to be drawn.
pub fn draw(
    file: &Path,
    scene: &mut Scene,
    elements: Option<&SymmetryElements>,
    cell: &Cell,
    range: CellRange,
) -> Result<(), Failure> {
    let Some(elements) = elements else {
        return Ok(());
    };
    let drawn = add_symmetry_elements(scene, elements, cell, range, Shown::default());
    drawn.map_err(|reason| Failure::Symmetry {
        file: file.to_owned(),
        reason,
    })
}

fn axis(axis: &Axis) -> SymmetryElement {
    let kind = match (axis.rotoinversion(), axis.screw()) {
        (Some(_), _) => "rotoinversion",
        (None, 0) => "rotation",
        (None, _) => "screw",
    };
    SymmetryElement {
        kind,
        symbol: axis.to_string(),
        direction: Some(axis.line().direction()),
        point: numbers(axis.line().point()),
        screw: axis.screw_vector().map(numbers),
        glide: None,
        inversion_points: axis
            .inversion_points()
            .iter()
            .copied()
            .map(numbers)
            .collect(),
    }
}

fn plane(plane: &ReflectionPlane) -> SymmetryElement {
    let glide = plane.glides().first().copied();
    SymmetryElement {
        kind: if glide.is_some() { "glide" } else { "mirror" },
        symbol: plane.to_string(),
        direction: Some(plane.place().normal()),
        point: numbers(plane.place().point()),
        screw: None,
        glide: glide.map(numbers),
        inversion_points: Vec::new(),
    }
}

fn numbers(point: [Fraction; 3]) -> [f64; 3] {
    point.map(|part| *part.numer() as f64 / *part.denom() as f64)
}
