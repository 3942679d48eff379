//! How atoms are written as extended XYZ: the lattice in the comment line, so that programs know the
//! cell; and how they are read, without it.
//!
//! The format is the one of ASE and OVITO: a line with the number of atoms, a line with
//! `Lattice="…"` (the three edge vectors of the block one after another, in ångström) and
//! `Properties=…`, then a line for each atom.

use std::fmt::Write;

use super::{Atom, Cell, CellRange, Element};

/// Why a text is no list of atoms.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum XyzError {
    /// The first line is no number.
    #[error("line 1: an XYZ file begins with the number of its atoms")]
    Count,
    /// A line begins with what is no element.
    #[error("line {line}: `{name}` is no element")]
    Element {
        /// The line, from 1.
        line: usize,
        /// What is there, shortened when long.
        name: String,
    },
    /// A line has no place, or one that is no number or beyond 1e9 ångström.
    #[error("line {line}: an element and three numbers are needed")]
    Place {
        /// The line, from 1.
        line: usize,
    },
    /// There are fewer lines than the first one promises.
    #[error(
        "line 1: {promised} atoms are promised, but the file is cut off after {found}, at line {line}"
    )]
    CutOff {
        /// The last line, from 1.
        line: usize,
        /// The number of atoms in the first line.
        promised: usize,
        /// The number that is there.
        found: usize,
    },
}

/// The largest coordinate that is read, in ångström.
const FARTHEST: f64 = 1e9;

/// The elements and Cartesian places in ångström of the first picture of an XYZ file: the number of atoms, a
/// line of comment, then a line for each atom, of which columns after the place are left out.
///
/// ```
/// use ga_design::crystallography::xyz;
///
/// let water = xyz::read("3\nwater\nO 0 0 0\nH 0.76 0.59 0\nH -0.76 0.59 0\n")?;
/// assert_eq!(water[0].0.symbol(), "O");
/// assert_eq!(water[2].1, [-0.76, 0.59, 0.0]);
/// # Ok::<(), xyz::XyzError>(())
/// ```
///
/// # Errors
/// [`XyzError`] with the line that is wrong.
pub fn read(text: &str) -> Result<Vec<(Element, [f64; 3])>, XyzError> {
    let mut lines = text.lines();
    let first = lines.next().unwrap_or_default();
    let promised: usize = first.trim().parse().map_err(|_| XyzError::Count)?;
    let mut atoms = Vec::new();
    for (row, line) in lines.skip(1).take(promised).enumerate() {
        let line_number = row + 3;
        let mut words = line.split_whitespace();
        let name = words.next().unwrap_or_default();
        let element = Element::from_label(name).ok_or_else(|| XyzError::Element {
            line: line_number,
            name: name.chars().take(40).collect(),
        })?;
        let mut number = || {
            let value: Option<f64> = words.next()?.parse().ok();
            value.filter(|value| value.abs() < FARTHEST)
        };
        let (Some(x), Some(y), Some(z)) = (number(), number(), number()) else {
            return Err(XyzError::Place { line: line_number });
        };
        atoms.push((element, [x, y, z]));
    }
    if atoms.len() < promised {
        return Err(XyzError::CutOff {
            line: text.lines().count().max(1),
            promised,
            found: atoms.len(),
        });
    }
    Ok(atoms)
}

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

#[cfg(test)]
mod tests {
    use super::{XyzError, read, write};
    use crate::crystallography::{CellRange, Expansion, cif};

    #[test]
    fn what_is_written_is_read() -> Result<(), Box<dyn std::error::Error>> {
        let text = include_str!("../../data/cif/quartz.cif");
        let crystal = cif::read_str("quartz.cif", text)?.crystal;
        let atoms = Expansion::default().unit_cell(&crystal)?;
        let written = write(&crystal.name, &crystal.cell, CellRange::UNIT, &atoms);
        let found = read(&written)?;
        assert_eq!(found.len(), atoms.len());
        for ((element, place), atom) in found.iter().zip(&atoms) {
            assert_eq!(*element, atom.element);
            for (read, made) in place.iter().zip(atom.cart) {
                assert!((read - made).abs() < 1e-8);
            }
        }
        Ok(())
    }

    #[test]
    fn the_line_that_is_wrong_is_told() {
        let place = |line| Err(XyzError::Place { line });
        assert_eq!(read(""), Err(XyzError::Count));
        assert_eq!(read("-1\n\n"), Err(XyzError::Count));
        assert_eq!(read("0\n\n"), Ok(Vec::new()));
        assert_eq!(read("1\n\nC 0 0"), place(3));
        assert_eq!(read("2\n\nC 0 0 0\nC 0 nan 0"), place(4));
        assert_eq!(read("1\n\nC 0 0 1e9"), place(3));
        let name = String::from("7q");
        assert_eq!(
            read("1\n\n7q 0 0 0"),
            Err(XyzError::Element { line: 3, name })
        );
        let cut_off = |line, promised, found| {
            Err(XyzError::CutOff {
                line,
                promised,
                found,
            })
        };
        assert_eq!(read("1"), cut_off(1, 1, 0));
        assert_eq!(read("2\n\nC 0 0 0\n"), cut_off(3, 2, 1));
        assert_eq!(
            read(&format!("{}\n\nC 0 0 0", usize::MAX)),
            cut_off(3, usize::MAX, 1)
        );
    }
}
