//! How the atom sites of a data block are read.

use super::super::cell::Cell;
use super::super::crystal::{Measured, Site};
use super::super::elements::Element;
use super::block::Block;
use super::extract::required;
use super::problem::Problem;
use super::token::Value;
use super::{Located, Warnings};

/// The data names of coordinates: fractional ones, then Cartesian ones in ångström.
pub const COORDINATES: [&str; 6] = [
    "_atom_site_fract_x",
    "_atom_site_fract_y",
    "_atom_site_fract_z",
    "_atom_site_cartn_x",
    "_atom_site_cartn_y",
    "_atom_site_cartn_z",
];

const LABELS: [&str; 3] = [
    "_atom_site_label",
    "_atom_site_label_atom_id",
    "_atom_site_id",
];
const TYPES: [&str; 1] = ["_atom_site_type_symbol"];
const OCCUPANCIES: [&str; 1] = ["_atom_site_occupancy"];
const FLAGS: [&str; 1] = ["_atom_site_calc_flag"];
const FORMULA: [&str; 3] = [
    "_chemical_formula_sum",
    "_chemical_formula_iupac",
    "_chemical_formula_moiety",
];
const TYPE_LIST: [&str; 1] = ["_atom_type_symbol"];

/// The most sites that a crystal may have.
const MOST_SITES: usize = 1_000_000;

/// Fractional coordinates beyond this are mistakes.
const FARTHEST: f64 = 1000.0;

/// A little above 1 is how refinements end; occupancies beyond this are something else, such as the
/// number of hydrogens.
const LARGEST_OCCUPANCY: f64 = 2.0;

type Column<'t, 'a> = (&'t str, Vec<Value<'a>>);

/// The sites, in the order of the file.
pub fn sites(
    block: &Block<'_>,
    cell: &Cell,
    warnings: &mut Warnings,
) -> Result<Vec<Site>, Located> {
    let [fx, fy, fz, cx, cy, cz] = COORDINATES;
    let cartesian = !block.has(&[fx, fy, fz]);
    let names = if cartesian {
        [cx, cy, cz]
    } else {
        [fx, fy, fz]
    };
    let [xs, ys, zs] = [
        coordinates(block, names[0])?,
        coordinates(block, names[1])?,
        coordinates(block, names[2])?,
    ];
    if xs.len() > MOST_SITES {
        let problem = Problem::TooLarge {
            what: "atom sites",
            limit: MOST_SITES,
        };
        return Err(Located::new(block.line, problem));
    }
    let labels = block.column(&LABELS)?;
    let types = block.column(&TYPES)?;
    let occupancies = block.column(&OCCUPANCIES)?;
    let flags = block.column(&FLAGS)?;
    let known = elements_of_substance(block)?;
    if cartesian {
        let message = "Cartesian coordinates are taken with a along x and b in the xy plane";
        warnings.add(block.line, message);
    }
    let mut sites = Vec::with_capacity(xs.len());
    for (row, ((x, y), z)) in xs.iter().zip(&ys).zip(&zs).enumerate() {
        let label = cell_of(&labels, row).and_then(|value| value.known());
        let symbol = cell_of(&types, row).and_then(|value| value.known());
        let flag = cell_of(&flags, row).and_then(|value| value.known());
        if flag.is_some_and(|flag| flag.eq_ignore_ascii_case("dum")) {
            let shown = label.or(symbol).unwrap_or("without label");
            let message = format!("the site {shown:.40} is a dummy and is left out");
            warnings.add(x.line, message);
            continue;
        }
        if [x, y, z].iter().any(|value| value.known().is_none()) {
            let shown = label.or(symbol).unwrap_or("without label");
            let message = format!("the site {shown:.40} has no coordinates and is left out");
            warnings.add(x.line, message);
            continue;
        }
        let mut fract = [
            required(names[0], x)?,
            required(names[1], y)?,
            required(names[2], z)?,
        ];
        if cartesian {
            let position = cell.fractional(fract.map(|coordinate| coordinate.value));
            fract = position.map(|value| Measured {
                value,
                uncertainty: None,
            });
        }
        for (coordinate, tag) in fract.iter().zip(names) {
            // A range refuses NaN as well.
            if !(-FARTHEST..=FARTHEST).contains(&coordinate.value) {
                let (tag, found) = (tag.to_owned(), coordinate.value);
                return Err(Located::new(x.line, Problem::FarAway { tag, found }));
            }
        }
        let occupancy = match cell_of(&occupancies, row).filter(|value| value.known().is_some()) {
            Some(value) => occupancy(&value, warnings)?,
            None => 1.0,
        };
        let element = element(symbol, label, &known).unwrap_or_else(|| {
            let shown = symbol.or(label).unwrap_or("?");
            warnings.add(
                x.line,
                format!("`{shown:.40}` names no element; the atom is kept as X"),
            );
            Element::UNKNOWN
        });
        let label = match label.or(symbol) {
            Some(text) => text.chars().take(40).collect(),
            None => format!("{}{}", element.symbol(), row + 1),
        };
        sites.push(Site {
            label,
            element,
            fract,
            occupancy,
        });
    }
    if sites.is_empty() {
        return Err(Located::new(block.line, Problem::NoSites));
    }
    Ok(sites)
}

fn coordinates<'a>(block: &Block<'a>, tag: &'static str) -> Result<Vec<Value<'a>>, Located> {
    block
        .column(&[tag])?
        .map(|(_, values)| values)
        .ok_or_else(|| {
            Located::new(
                block.line,
                Problem::MissingCoordinate {
                    tag: tag.to_owned(),
                },
            )
        })
}

fn cell_of<'a>(column: &Option<Column<'_, 'a>>, row: usize) -> Option<Value<'a>> {
    column
        .as_ref()
        .and_then(|(_, values)| values.get(row).copied())
}

/// The type symbol names the element; without one, the beginning of the label does.
fn element(symbol: Option<&str>, label: Option<&str>, known: &[Element]) -> Option<Element> {
    symbol
        .and_then(Element::from_type_symbol)
        .or_else(|| label.and_then(|label| Element::from_label_among(label, known)))
}

/// The elements that the formula and the list of atom types name.
fn elements_of_substance(block: &Block<'_>) -> Result<Vec<Element>, Located> {
    let mut found: Vec<Element> = Vec::new();
    let mut add = |symbol: &str| {
        if let Some(element) = Element::from_type_symbol(symbol)
            && !found.contains(&element)
        {
            found.push(element);
        }
    };
    let types = block.column(&TYPE_LIST)?;
    for symbol in types.iter().flat_map(|(_, types)| types) {
        add(symbol.known().unwrap_or_default());
    }
    let formula = block.first(&FORMULA).and_then(|(_, value)| value.known());
    // A symbol is a capital and the small letter that may follow.
    let formula = formula.unwrap_or_default();
    for (at, _) in formula.match_indices(|c: char| c.is_ascii_uppercase()) {
        let rest = formula.get(at..).unwrap_or_default();
        let small = rest
            .chars()
            .nth(1)
            .is_some_and(|next| next.is_ascii_lowercase());
        add(rest.get(..if small { 2 } else { 1 }).unwrap_or_default());
    }
    Ok(found)
}

fn occupancy(value: &Value<'_>, warnings: &mut Warnings) -> Result<f64, Located> {
    let tag = OCCUPANCIES[0];
    let found = required(tag, value)?.value;
    if found < 0.0 {
        let tag = tag.to_owned();
        return Err(Located::new(value.line, Problem::Occupancy { tag, found }));
    }
    if found > LARGEST_OCCUPANCY {
        let message = format!("the occupancy {found} is no part of a site; it is taken as 1");
        warnings.add(value.line, message);
        return Ok(1.0);
    }
    Ok(found)
}
