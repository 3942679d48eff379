//! How a crystal is written as a CIF file that this reader and others read back.

use std::fmt::{self, Write};

use super::super::crystal::{Crystal, Measured};
use super::super::{Atom, CellRange, SpaceGroup};

/// The text of a CIF file with the cell, the symmetry as symbol, number and operations, and the
/// asymmetric unit as it was read.
///
/// ```
/// use ga_design::crystallography::cif;
///
/// let text = include_str!("../../../data/cif/quartz.cif");
/// let quartz = cif::read_str("quartz.cif", text)?.crystal;
/// let again = cif::read_str("again.cif", &cif::write(&quartz))?.crystal;
/// assert_eq!(again, quartz);
/// # Ok::<(), cif::CifError>(())
/// ```
#[must_use]
pub fn write(crystal: &Crystal) -> String {
    let mut text = head(&crystal.name, crystal.cell.edges(), crystal.cell.angles());
    let known = SpaceGroup::identify(&crystal.operations);
    let number = crystal.number.map(|number| number.to_string());
    item(&mut text, "_space_group_IT_number", number.as_deref());
    let symbol = crystal.hermann_mauguin.as_deref();
    item(&mut text, "_space_group_name_H-M_alt", symbol);
    item(
        &mut text,
        "_space_group_name_Hall",
        known.map(|group| group.hall),
    );
    text.push_str("\nloop_\n_space_group_symop_id\n_space_group_symop_operation_xyz\n");
    for (at, operation) in crystal.operations.iter().enumerate() {
        line(&mut text, format_args!("{} '{operation}'", at + 1));
    }
    text.push_str(SITES);
    for site in &crystal.sites {
        let [x, y, z] = site.fract.map(measured);
        let (label, symbol) = (quoted(&site.label), site.element.symbol());
        let occupancy = plain(site.occupancy);
        line(
            &mut text,
            format_args!("{label} {symbol} {x} {y} {z} {occupancy}"),
        );
    }
    text
}

/// The text of a CIF file with all atoms of a block of cells, as one large cell without symmetry
/// (`P 1`); fractions count from the low corner of the block.
#[must_use]
pub fn write_block(crystal: &Crystal, range: CellRange, atoms: &[Atom]) -> String {
    let cells = [0, 1, 2].map(|i| f64::from(range.high[i]) - f64::from(range.low[i]));
    let edges = crystal.cell.edges();
    let edges = [0, 1, 2].map(|i| edges[i] * cells[i]);
    let mut text = head(&crystal.name, edges, crystal.cell.angles());
    item(&mut text, "_space_group_IT_number", Some("1"));
    item(&mut text, "_space_group_name_H-M_alt", Some("P 1"));
    item(&mut text, "_space_group_name_Hall", Some("P 1"));
    text.push_str("\nloop_\n_space_group_symop_id\n_space_group_symop_operation_xyz\n1 'x,y,z'\n");
    text.push_str(SITES);
    for atom in atoms {
        let place = |i: usize| {
            let fraction = (atom.fract[i] - f64::from(range.low[i])) / cells[i];
            // Nine digits of the largest block are less than the last of any measurement.
            (fraction * 1e12).round() / 1e12
        };
        let [x, y, z] = [0, 1, 2].map(place).map(plain);
        let (label, symbol) = (quoted(&atom.label), atom.element.symbol());
        let occupancy = plain(atom.occupancy);
        line(
            &mut text,
            format_args!("{label} {symbol} {x} {y} {z} {occupancy}"),
        );
    }
    text
}

const SITES: &str = "\nloop_\n_atom_site_label\n_atom_site_type_symbol\n_atom_site_fract_x\n\
    _atom_site_fract_y\n_atom_site_fract_z\n_atom_site_occupancy\n";

fn head(name: &str, edges: [f64; 3], angles: [f64; 3]) -> String {
    let block: String = name
        .chars()
        .map(|c| if c.is_ascii_alphanumeric() { c } else { '_' })
        .take(60)
        .collect();
    let block = if block.is_empty() {
        "crystal"
    } else {
        block.as_str()
    };
    let mut text = format!("data_{block}\n");
    // A name that the block itself tells need not stand twice.
    if block != name {
        item(&mut text, "_chemical_name_common", Some(name));
    }
    let parameters = [
        "length_a",
        "length_b",
        "length_c",
        "angle_alpha",
        "angle_beta",
        "angle_gamma",
    ];
    for (tag, value) in parameters.into_iter().zip(edges.into_iter().chain(angles)) {
        line(&mut text, format_args!("_cell_{tag} {value}"));
    }
    text
}

/// A data name with its value; nothing where the value is not known.
fn item(text: &mut String, tag: &str, value: Option<&str>) {
    if let Some(value) = value.filter(|value| !value.is_empty()) {
        line(text, format_args!("{tag} {}", quoted(value)));
    }
}

fn line(text: &mut String, content: fmt::Arguments<'_>) {
    // Writing to a string cannot fail.
    let _ = text.write_fmt(content);
    text.push('\n');
}

/// A value as one word: bare where that is unmistakable, else between marks that it does not hold.
fn quoted(value: &str) -> String {
    let value: String = value
        .chars()
        .map(|c| if c.is_control() { ' ' } else { c })
        .collect();
    let begins_plain = value.starts_with(|c: char| c.is_ascii_alphanumeric());
    let keyword = ["data_", "loop_", "save_", "stop_", "global_"];
    let small = value.to_ascii_lowercase();
    let is_keyword = keyword.iter().any(|word| small.starts_with(word));
    let is_word = value
        .chars()
        .all(|c| c.is_ascii_graphic() && !"'\"#;[]{}".contains(c));
    if begins_plain && is_word && !is_keyword {
        value
    } else if !value.contains('\'') {
        format!("'{value}'")
    } else if !value.contains('"') {
        format!("\"{value}\"")
    } else {
        format!("'{}'", value.replace('\'', "\u{2019}"))
    }
}

/// A number that reads back as itself; tiny ones with an exponent instead of hundreds of zeros.
fn plain(value: f64) -> String {
    if value != 0.0 && value.abs() < 1e-9 {
        format!("{value:e}")
    } else {
        value.to_string()
    }
}

/// A number with its uncertainty in units of the last digit, where both come out as they were.
fn measured(value: Measured) -> String {
    let text = plain(value.value);
    let Some(uncertainty) = value.uncertainty else {
        return text;
    };
    let with_digits = (0..=15).find_map(|decimals: usize| {
        let units = (uncertainty * 10f64.powi(decimals as i32)).round();
        let text = format!("{:.decimals$}({units})", value.value);
        (super::number::measured(&text) == Some(value)).then_some(text)
    });
    with_digits.unwrap_or(text)
}
