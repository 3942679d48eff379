//! Decides what is said about a crystal in JSON: the contract with other programs.

use super::symmetry::SymmetryElement;
use crate::unit_cell::UnitCell;
use ga_design::crystallography::bonds::coordination;
use ga_design::crystallography::{Atom, Bond, CellRange, Crystal};
use serde::Serialize;
use std::collections::BTreeMap;
use std::path::PathBuf;

/// Daltons in a cubic ångström, as grams in a cubic centimetre.
const GRAMS_PER_CUBIC_CENTIMETRE: f64 = 1.660_539_066_60;

/// A crystal, as JSON tells it; fields may be added, never renamed.
#[derive(Debug, Serialize)]
pub struct Document {
    /// The name of its data block.
    pub name: String,
    /// What one unit cell holds, in the order of Hill, occupancies counted.
    pub formula: String,
    /// The number of the space group, 1 to 230.
    pub number: Option<u32>,
    /// Its Hermann–Mauguin symbol.
    pub hm: Option<String>,
    /// The unit cell.
    pub cell: UnitCell,
    /// In grams per cubic centimetre; nothing where an element is not known.
    pub density: Option<f64>,
    /// The atoms of one unit cell.
    pub atoms: Vec<CellAtom>,
    /// The bonds of the unit cell, those across its faces included; nothing where none were looked for.
    pub bonds: Option<Vec<CellBond>>,
    /// The block of cells that was built.
    pub cells: Block,
    /// The files that were saved.
    pub files: Vec<PathBuf>,
    /// The symmetry elements of one cell, where they were asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub symmetry_elements: Option<Vec<SymmetryElement>>,
}

/// An atom of the unit cell.
#[derive(Debug, Serialize)]
pub struct CellAtom {
    /// The label of its site.
    pub label: String,
    /// The symbol of its element; `X` where it is not known.
    pub element: &'static str,
    /// In fractions of the edges, from 0 up to 1.
    pub fract: [f64; 3],
    /// In ångström.
    pub cart: [f64; 3],
    /// The part of the cells in which it is there.
    pub occupancy: f64,
    /// The number of its bonds; nothing where none were looked for.
    pub coordination: Option<usize>,
}

/// A bond of the unit cell.
#[derive(Debug, Serialize)]
pub struct CellBond {
    /// The atoms that it joins, counted from 0.
    pub atoms: [usize; 2],
    /// The cell of the second, in cell edges.
    pub image: [i32; 3],
    /// In ångström.
    pub length: f64,
}

/// A block of cells.
#[derive(Debug, Serialize)]
pub struct Block {
    /// Its first corner, in cell edges.
    pub from: [i32; 3],
    /// Its last corner, in cell edges.
    pub to: [i32; 3],
    /// The number of its atoms.
    pub atoms: u64,
}

impl Document {
    /// What is to be said about a crystal with these atoms in its unit cell.
    pub fn new(
        crystal: &Crystal,
        atoms: &[Atom],
        bonds: Option<&[Bond]>,
        range: CellRange,
        files: Vec<PathBuf>,
    ) -> Self {
        let counts = bonds.map(|bonds| coordination(bonds, atoms.len()));
        let count = |at: usize| counts.as_ref().and_then(|counts| counts.get(at).copied());
        let volume = crystal.cell.volume();
        Self {
            name: crystal.name.clone(),
            formula: formula(atoms),
            number: crystal.number,
            hm: crystal.hermann_mauguin.clone(),
            cell: UnitCell::of(&crystal.cell),
            density: density(atoms, volume),
            atoms: atoms
                .iter()
                .enumerate()
                .map(|(at, atom)| described(atom, count(at)))
                .collect(),
            bonds: bonds.map(|bonds| bonds.iter().map(joined).collect()),
            cells: Block {
                from: range.low,
                to: range.high,
                atoms: range.count().saturating_mul(atoms.len() as u64),
            },
            files,
            symmetry_elements: None,
        }
    }

    /// The number of atoms of each element, by symbol.
    pub fn elements(&self) -> BTreeMap<&'static str, usize> {
        let mut counts = BTreeMap::new();
        for atom in &self.atoms {
            *counts.entry(atom.element).or_insert(0) += 1;
        }
        counts
    }
}

fn described(atom: &Atom, coordination: Option<usize>) -> CellAtom {
    CellAtom {
        label: atom.label.to_string(),
        element: atom.element.symbol(),
        fract: atom.fract,
        cart: atom.cart,
        occupancy: atom.occupancy,
        coordination,
    }
}

fn joined(bond: &Bond) -> CellBond {
    let Bond {
        atoms,
        image,
        length,
    } = *bond;
    CellBond {
        atoms,
        image,
        length,
    }
}

/// What a cell holds, in the order of Hill: carbon, hydrogen, then the alphabet; without carbon all by
/// the alphabet.
fn formula(atoms: &[Atom]) -> String {
    let mut amounts: BTreeMap<&str, f64> = BTreeMap::new();
    for atom in atoms {
        *amounts.entry(atom.element.symbol()).or_default() += atom.occupancy;
    }
    let has_carbon = amounts.contains_key("C");
    let mut order: Vec<_> = amounts.into_iter().collect();
    order.sort_by_key(|&(symbol, _)| match symbol {
        "C" => (0, symbol),
        "H" if has_carbon => (1, symbol),
        _ => (2, symbol),
    });
    let words = order.iter().map(|(symbol, amount)| {
        let amount = (amount * 1e3).round() / 1e3;
        if amount == 1.0 {
            (*symbol).to_owned()
        } else {
            format!("{symbol}{amount}")
        }
    });
    words.collect::<Vec<_>>().join(" ")
}

fn density(atoms: &[Atom], volume: f64) -> Option<f64> {
    let known = atoms.iter().all(|atom| atom.element.mass() > 0.0);
    let mass: f64 = atoms
        .iter()
        .map(|atom| atom.element.mass() * atom.occupancy)
        .sum();
    known.then_some(mass / volume * GRAMS_PER_CUBIC_CENTIMETRE)
}
