//! What a crystal is before it is built: a cell, its symmetry, and the sites that differ by more
//! than symmetry.

use super::cell::Cell;
use super::elements::Element;
use super::operation::Operation;

/// A number with its standard uncertainty: `1.234(5)` is 1.234 ± 0.005.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measured {
    /// The value.
    pub value: f64,
    /// The standard uncertainty, where one is given.
    pub uncertainty: Option<f64>,
}

/// An atom of the asymmetric unit.
#[derive(Clone, Debug, PartialEq)]
pub struct Site {
    /// The label in the file, such as `O1`.
    pub label: String,
    /// The element.
    pub element: Element,
    /// The position in fractions of the cell edges, as given (not reduced to the unit cell).
    pub fract: [Measured; 3],
    /// The part of the cells in which the site is filled, 1 when not given.
    pub occupancy: f64,
}

impl Site {
    /// The position in fractions of the cell edges.
    pub fn position(&self) -> [f64; 3] {
        self.fract.map(|coordinate| coordinate.value)
    }
}

/// A crystal as files describe it.
#[derive(Clone, Debug, PartialEq)]
pub struct Crystal {
    /// The name of the data block, or of the substance.
    pub name: String,
    /// The number of the space group in International Tables, when it is known.
    pub number: Option<u32>,
    /// The Hermann–Mauguin symbol, with origin or axes choice where there is one (`F d -3 m:2`);
    /// when the setting is in no table, the file's own spelling, or else the symbol of the standard
    /// setting.
    pub hermann_mauguin: Option<String>,
    /// The unit cell.
    pub cell: Cell,
    /// All operations modulo the lattice, centring translations included, the identity first.
    pub operations: Vec<Operation>,
    /// The sites of the asymmetric unit, in the order of the file.
    pub sites: Vec<Site>,
}
