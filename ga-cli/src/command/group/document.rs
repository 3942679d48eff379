//! Decides what is told about a group in JSON.

use super::request::Notation;
use super::versor::Versor;
use crate::command::crystal::symmetry::SymmetryElement;
use crate::unit_cell::UnitCell;
use ga_design::crystallography::{SpaceGroup, SpaceGroupGenerators};
use serde::Serialize;
use std::path::PathBuf;

/// A group of some kind.
#[derive(Debug, Serialize)]
#[serde(untagged)]
pub enum Document {
    /// With a lattice.
    Periodic(Box<Periodic>),
    /// Without.
    Point(Box<Point>),
}

/// A space, plane, frieze, layer or rod group.
#[derive(Debug, Serialize)]
pub struct Periodic {
    /// space, plane, frieze, layer or rod.
    pub kind: String,
    /// The number in International Tables.
    pub number: u32,
    /// The Hermann–Mauguin symbol.
    pub hm: String,
    /// The symbols.
    pub symbols: Symbols,
    /// The Hall symbol; of the space group with all translations, where there are fewer.
    pub hall: String,
    /// The Schoenflies symbol of a space group.
    pub schoenflies: Option<String>,
    /// The point group.
    pub point_group: String,
    /// The geometric symbol; of the space group with all translations, where there are fewer.
    pub geometric: String,
    /// The crystal system; in the plane that of the lattice.
    pub system: String,
    /// The point group with an inversion added, of a space group.
    pub laue_class: Option<&'static str>,
    /// The number of operations modulo all translations: the order of the point group.
    pub order: usize,
    /// The lattice.
    pub lattice: Lattice,
    /// The setting.
    pub setting: Setting,
    /// How the text was read.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub notation: Option<Notation>,
    /// What it means in other notations.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub also: Vec<Reading>,
    /// The space group whose generators generate this group.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub space_group: Option<Reading>,
    /// The lattice points of one cell in fractions of its edges, the origin first.
    pub centring: Vec<Vec<f64>>,
    /// All operations modulo the edges, the identity first.
    pub operations: Vec<String>,
    /// The generators in terms of the roots, in the standard setting of the space group.
    pub generators: Vec<String>,
    /// The roots.
    pub roots: RootVectors,
    /// What depends on a cell.
    #[serde(flatten, skip_serializing_if = "Option::is_none")]
    pub placed: Option<Placed>,
    /// The Wyckoff positions.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub wyckoff: Option<Vec<Wyckoff>>,
    /// The point of `--at`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub site: Option<super::site::Site>,
    /// The symmetry elements of one cell.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub symmetry_elements: Option<Vec<SymmetryElement>>,
    /// The fundamental domain.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub domain: Option<super::domain::Domain>,
    /// What files show.
    #[serde(flatten)]
    pub drawn: Drawn,
}

/// What files were made, and of what motif.
#[derive(Debug, Default, Serialize)]
pub struct Drawn {
    /// The motif.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub motif: Option<MotifPlace>,
    /// The files.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub files: Vec<PathBuf>,
}

/// Where the motif is, and how often.
#[derive(Debug, Clone, Serialize)]
pub struct MotifPlace {
    /// Its name or file.
    pub name: String,
    /// Its middle: in fractions of the edges, or in space where there are none.
    pub place: [f64; 3],
    /// Its radius in ångström.
    pub size: f64,
    /// The number of its copies in the files.
    pub copies: u64,
    /// The corners of the block of cells, in edges.
    pub cells: [[i32; 3]; 2],
}

/// The symbols of a group.
#[derive(Debug, Serialize)]
pub struct Symbols {
    /// Hermann–Mauguin, short.
    pub short: String,
    /// With the axes and planes of every direction.
    pub full: String,
    /// With the further axes and planes that the lattice adds, of a space group.
    pub extended: Option<String>,
    /// With the choice of origin or axes, where there is one.
    pub qualified: String,
}

/// The lattice of a group.
#[derive(Debug, Serialize)]
pub struct Lattice {
    /// The Bravais lattice, or the lattice of fewer translations.
    pub bravais: String,
    /// Its Pearson symbol, of a space group.
    pub pearson: Option<&'static str>,
    /// The letter of the centring.
    pub centring: String,
}

/// A choice of cell and origin.
#[derive(Debug, Serialize)]
pub struct Setting {
    /// The origin choice 1 or 2, or the axes H or R.
    pub choice: Option<String>,
    /// Whether it is the one that the number stands for.
    pub standard: bool,
    /// The change of basis from the standard setting, x = P x′ + p as a triplet.
    pub from_standard: Option<String>,
    /// The other settings that the symbol given fits.
    pub others: Vec<String>,
}

/// A group that is meant besides.
#[derive(Debug, Serialize)]
pub struct Reading {
    /// The notation in which it is.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub notation: Option<Notation>,
    /// The number of the space group.
    pub number: u32,
    /// Its Hermann–Mauguin symbol.
    pub hm: String,
}

/// The roots of a group.
#[derive(Debug, Serialize)]
pub struct RootVectors {
    /// The number p of the angle π/p from a to b.
    pub p: u32,
    /// The number q of the angle π/q from b to c; null for symbols of one number.
    pub q: Option<u32>,
    /// Along which directions of the standard cell a, b and c lie; `-` for one that is not used.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub directions: Vec<String>,
    /// The unit vectors themselves, as p and q give them.
    pub vectors: [[f64; 3]; 3],
}

/// What depends on a cell.
#[derive(Debug, Serialize)]
pub struct Placed {
    /// The cell.
    pub cell: UnitCell,
    /// The versors of the generators.
    pub generator_versors: Vec<Versor>,
    /// The versors of the operations, in their order.
    pub versors: Vec<Versor>,
}

/// A Wyckoff position.
#[derive(Debug, Serialize)]
pub struct Wyckoff {
    /// Its letter; null where International Tables give none.
    pub letter: Option<char>,
    /// The number of points per cell.
    pub multiplicity: usize,
    /// The oriented symbol of the site symmetry.
    pub site_symmetry: String,
    /// The triplets, as many as the multiplicity.
    pub coordinates: Vec<String>,
}

/// A point group.
#[derive(Debug, Serialize)]
pub struct Point {
    /// point.
    pub kind: &'static str,
    /// The place among the 32 crystal classes of International Tables, from 1.
    pub number: Option<usize>,
    /// The International symbol, if it is one of crystals.
    pub hm: Option<&'static str>,
    /// The Schoenflies symbol.
    pub schoenflies: String,
    /// The geometric symbol.
    pub geometric: String,
    /// The same with bars.
    pub overlined: String,
    /// The number p.
    pub p: u32,
    /// The number q; null for symbols of one number.
    pub q: Option<u32>,
    /// The crystal system.
    pub system: Option<String>,
    /// The Laue class.
    pub laue_class: Option<&'static str>,
    /// The number of transformations.
    pub order: usize,
    /// Whether all are rotations.
    pub chiral: bool,
    /// Whether the inversion is among them.
    pub centrosymmetric: bool,
    /// How the text was read.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub notation: Option<Notation>,
    /// The roots.
    pub roots: RootVectors,
    /// The generating words in them.
    pub generators: Vec<String>,
    /// The conjugacy classes.
    pub classes: Vec<Class>,
    /// The transformations, the identity first.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub versors: Vec<Transformation>,
    /// What files show.
    #[serde(flatten)]
    pub drawn: Drawn,
}

/// A conjugacy class.
#[derive(Debug, Serialize)]
pub struct Class {
    /// How many transformations.
    pub size: usize,
    /// How often each must follow itself to move nothing.
    pub order: usize,
    /// identity, rotation, reflection, inversion or rotoreflection.
    pub kind: &'static str,
    /// Their places in the list of versors, from 0.
    pub members: Vec<usize>,
}

/// A transformation of a point group.
#[derive(Debug, Serialize)]
pub struct Transformation {
    /// How often it must follow itself to move nothing.
    pub order: usize,
    /// identity, rotation, reflection, inversion or rotoreflection.
    pub kind: &'static str,
    /// Its versor.
    #[serde(flatten)]
    pub versor: Versor,
}

impl RootVectors {
    /// Of a space group.
    pub fn of(group: &SpaceGroupGenerators) -> Self {
        let directions = group.roots.iter().map(ToString::to_string).collect();
        Self::of_point(group.symbol.point, directions)
    }

    /// Of a point group, with the directions that are told of them.
    pub fn of_point(
        symbol: ga_design::crystallography::PointSymbol,
        directions: Vec<String>,
    ) -> Self {
        let vectors = symbol.roots().map(|roots| roots.vectors());
        Self {
            p: symbol.p(),
            q: symbol.q(),
            directions,
            // Every symbol has roots.
            vectors: vectors.unwrap_or_default().map(|root| root.to_array()),
        }
    }
}

impl Reading {
    /// A space group by number and symbol.
    pub fn of(group: &SpaceGroup, notation: Option<Notation>) -> Self {
        Self {
            notation,
            number: group.number,
            hm: group.symbol.to_owned(),
        }
    }
}
