//! How atoms are written as extended XYZ: the lattice in the comment line, so that programs know the
//! cell.
//!
//! The format is the one of ASE and OVITO: a line with the number of atoms, a line with
//! `Lattice="…"` (the three edge vectors of the block one after another, in ångström) and
//! `Properties=…`, then a line for each atom.

use std::fmt::Write;

use super::{Atom, Cell, CellRange};

/// The text of an XYZ file with the atoms of a block of cells: element and Cartesian position in
/// ångström, and the occupancy where one is not 1.
///
/// ```
/// use ga_design::crystallography::{CellRange, Expansion, cif, xyz};
///
/// let text = include_str!("../../data/cif/halite.cif");
/// let crystal = cif::read_str("halite.cif", text)?.crystal;
/// let atoms = Expansion::default().unit_cell(&crystal)?;
/// let written = xyz::write(&crystal.name, &crystal.cell, CellRange::UNIT, &atoms);
/// let mut lines = written.lines();
/// assert_eq!(lines.next(), Some("8"));
/// assert!(lines.next().is_some_and(|line| line.starts_with("Lattice=\"5.64")));
/// assert_eq!(lines.next(), Some("Na 0 0 0"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[must_use]
pub fn write(name: &str, cell: &Cell, range: CellRange, atoms: &[Atom]) -> String {
    let count = [0, 1, 2].map(|i| f64::from(range.high[i]) - f64::from(range.low[i]));
    let edges = cell.edge_vectors();
    let lattice = [0, 1, 2].map(|i| edges[i].map(|value| (value * count[i]).to_string()));
    let has_occupancy = atoms.iter().any(|atom| atom.occupancy != 1.0);
    let occupancy = if has_occupancy { ":occupancy:R:1" } else { "" };
    // Quotation marks and line ends would end the value.
    let title: String = name
        .chars()
        .map(|c| {
            if c.is_control() || c == '"' || c == '\\' {
                ' '
            } else {
                c
            }
        })
        .collect();
    let mut text = format!(
        "{}\nLattice=\"{}\" Properties=species:S:1:pos:R:3{occupancy} pbc=\"T T T\" name=\"{title}\"\n",
        atoms.len(),
        lattice.as_flattened().join(" "),
    );
    for atom in atoms {
        let [x, y, z] = atom.cart.map(rounded);
        let symbol = atom.element.symbol();
        // Writing to a string cannot fail.
        let _ = write!(text, "{symbol} {x} {y} {z}");
        if has_occupancy {
            let _ = write!(text, " {}", atom.occupancy);
        }
        text.push('\n');
    }
    text
}

/// To a hundredth of the size of an atomic nucleus: what lies below is noise of the computation.
fn rounded(value: f64) -> f64 {
    // Zero without a sign.
    (value * 1e8).round() / 1e8 + 0.0
}
