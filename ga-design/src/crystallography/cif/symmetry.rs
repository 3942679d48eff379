//! How the symmetry of a data block is found: operations before Hall symbol before
//! Hermann–Mauguin symbol before number.
//!
//! Operations say everything, a Hall symbol too; a Hermann–Mauguin symbol may leave axes or origin
//! open, a number both. What is open is settled by the cell, and else by the standard setting.

use std::collections::HashSet;

use super::super::cell::Cell;
use super::super::closure::close;
use super::super::hall;
use super::super::operation::Operation;
use super::super::placement::SymmetricCell;
use super::super::symbols::SpaceGroup;
use super::block::Block;
use super::problem::Problem;
use super::token::Value;
use super::{Located, Warnings};

const OPERATIONS: [&str; 2] = [
    "_space_group_symop_operation_xyz",
    "_symmetry_equiv_pos_as_xyz",
];
const HALL: [&str; 2] = ["_space_group_name_hall", "_symmetry_space_group_name_hall"];
const HERMANN_MAUGUIN: [&str; 4] = [
    "_space_group_name_h-m_alt",
    "_symmetry_space_group_name_h-m",
    "_space_group_name_h-m_full",
    "_space_group_name_h-m",
];
const NUMBER: [&str; 2] = ["_space_group_it_number", "_symmetry_int_tables_number"];

/// The symmetry of structures with magnetic moments (magCIF).
const MAGNETIC: [&str; 7] = [
    "_space_group_symop_magn_operation_xyz",
    "_space_group_symop_magn_id",
    "_space_group_symop_magn_operation_mxmymz",
    "_space_group_magn_symop_operation_xyz",
    "_space_group_magn_number_bns",
    "_space_group_magn_name_bns",
    "_parent_space_group_name_h-m_alt",
];

/// The symmetry of structures with a modulation (msCIF).
const MODULATED: [&str; 4] = [
    "_space_group_symop_ssg_operation_algebraic",
    "_space_group_symop_ssg_id",
    "_space_group_ssg_name",
    "_space_group_ssg_name_it",
];

const COORDINATE_SYSTEM: [&str; 1] = ["_space_group_it_coordinate_system_code"];

/// The most operations that a file may list.
const MOST_LISTED: usize = 4096;

/// The symmetry of a crystal.
pub struct Symmetry {
    pub number: Option<u32>,
    pub hermann_mauguin: Option<String>,
    pub operations: Vec<Operation>,
}

/// The symmetry of a block, checked against the cell, whose line is `cell_line`.
pub fn symmetry(
    block: &Block<'_>,
    cell: &Cell,
    cell_line: usize,
    warnings: &mut Warnings,
) -> Result<Symmetry, Located> {
    let found = match listed(block, warnings)? {
        Some(operations) => from_operations(block, operations, warnings),
        None => named(block, cell, warnings)?,
    };
    SymmetricCell::new(&found.operations, cell)
        .map_err(|error| Located::new(cell_line, error.into()))?;
    Ok(found)
}

/// The group that the listed operations make; `None` when none is listed.
fn listed(block: &Block<'_>, warnings: &mut Warnings) -> Result<Option<Vec<Operation>>, Located> {
    let Some((_, values)) = block.column(&OPERATIONS)? else {
        return Ok(None);
    };
    let line = values.first().map_or(block.line, |value| value.line);
    if values.len() > MOST_LISTED {
        let problem = Problem::TooLarge {
            what: "symmetry operations",
            limit: MOST_LISTED,
        };
        return Err(Located::new(line, problem));
    }
    let mut operations: Vec<Operation> = Vec::with_capacity(values.len());
    for value in &values {
        let Some(text) = value.known() else { continue };
        let operation = text.parse().map_err(|reason| {
            let text = text.chars().take(60).collect();
            Located::new(value.line, Problem::Operation { text, reason })
        })?;
        if operations.contains(&operation) {
            warnings.add(
                value.line,
                format!("the operation {operation} is listed twice"),
            );
        } else {
            operations.push(operation);
        }
    }
    if operations.is_empty() {
        return Ok(None);
    }
    let group = close(&operations).map_err(|error| Located::new(line, error.into()))?;
    if group.len() > operations.len() {
        let (listed, all) = (operations.len(), group.len());
        let message =
            format!("{listed} operations are listed, but their group has {all}; all are used");
        warnings.add(line, message);
    }
    Ok(Some(group))
}

fn from_operations(
    block: &Block<'_>,
    operations: Vec<Operation>,
    warnings: &mut Warnings,
) -> Symmetry {
    let written_number = block.first(&NUMBER).and_then(|(_, value)| {
        let number = value.known().and_then(|text| text.parse::<u32>().ok());
        number
            .filter(|number| (1..=230).contains(number))
            .map(|number| (number, value.line))
    });
    let written_symbol = block
        .first(&HERMANN_MAUGUIN)
        .and_then(|(_, value)| value.known());
    if let Some(group) = SpaceGroup::identify(&operations) {
        disagreement(written_number, group.number, warnings);
        return of_group(group, operations);
    }
    // A setting that is in no table, such as another origin.
    let Some(found) = SpaceGroup::recognise(&operations) else {
        // A cell beyond all bounds: the file's own word counts.
        let written = written_number.map(|(number, _)| number);
        return Symmetry {
            number: written.filter(|number| has_point_group_order(*number, &operations)),
            hermann_mauguin: written_symbol.map(shortened),
            operations,
        };
    };
    disagreement(written_number, found.number, warnings);
    let means_it = |text: &&str| {
        let settings = SpaceGroup::from_symbol(text).unwrap_or_default();
        settings.iter().any(|group| group.number == found.number)
    };
    let symbol = written_symbol.filter(means_it);
    let standard = SpaceGroup::standard(found.number).map(SpaceGroup::qualified_symbol);
    if symbol.is_none() && written_number.is_none_or(|(number, _)| number != found.number) {
        warnings.add(
            block.line,
            format!(
                "the setting of the operations is in no table; they are those of `{}` (number {}), \
                 whose coordinates in terms of these are {}",
                standard.as_deref().unwrap_or_default(),
                found.number,
                found.from_standard
            ),
        );
    }
    Symmetry {
        number: Some(found.number),
        hermann_mauguin: symbol.map(shortened).or(standard),
        operations,
    }
}

/// Says so when the file writes another number than that of its operations.
fn disagreement(written: Option<(u32, usize)>, found: u32, warnings: &mut Warnings) {
    if let Some((number, line)) = written.filter(|(number, _)| *number != found) {
        let message = format!(
            "the space group number is {number}, but the operations are those of {found}; the \
             operations are used"
        );
        warnings.add(line, message);
    }
}

fn shortened(text: &str) -> String {
    text.chars().take(60).collect()
}

/// Whether a group has as many different matrices as the operations: if not, the file's word
/// about its group is wrong.
fn has_point_group_order(number: u32, operations: &[Operation]) -> bool {
    let order = |operations: &[Operation]| {
        let matrices: HashSet<_> = operations.iter().map(Operation::rotation).collect();
        matrices.len()
    };
    let standard = SpaceGroup::standard(number).and_then(|group| group.operations().ok());
    standard.is_some_and(|standard| order(&standard) == order(operations))
}

fn of_group(group: &SpaceGroup, operations: Vec<Operation>) -> Symmetry {
    Symmetry {
        number: Some(group.number),
        hermann_mauguin: Some(group.qualified_symbol()),
        operations,
    }
}

/// The group that the symbols or the number stand for.
fn named(block: &Block<'_>, cell: &Cell, warnings: &mut Warnings) -> Result<Symmetry, Located> {
    let symbol = block.first(&HERMANN_MAUGUIN).map(|(_, value)| value);
    let number = block.first(&NUMBER).map(|(_, value)| value);
    if let Some((_, value)) = block.first(&HALL) {
        let text = value.known().unwrap_or_default();
        match hall::operations(text) {
            Ok(operations) => return Ok(from_operations(block, operations, warnings)),
            Err(reason) => {
                let text = text.chars().take(60).collect();
                let problem = Problem::Hall { text, reason };
                if symbol.is_none() && number.is_none() {
                    return Err(Located::new(value.line, problem));
                }
                warnings.add(value.line, problem.to_string());
            }
        }
    }
    let written_number = match number.map(|value| group_number(&value)).transpose() {
        Ok(written) => written,
        // The symbol says enough.
        Err(error) if symbol.is_some() => {
            warnings.add(error.line, error.problem.to_string());
            None
        }
        Err(error) => return Err(error),
    };
    let (settings, line) = match (symbol, number) {
        (Some(value), _) => {
            let text = qualified(block, value.known().unwrap_or_default());
            let settings = settings(&text, value.line, warnings)?;
            (settings, value.line)
        }
        (None, Some(value)) => (
            written_number.map(SpaceGroup::settings).unwrap_or_default(),
            value.line,
        ),
        (None, None) => return Err(Located::new(block.line, without_symmetry(block))),
    };
    let disagrees = |number: &u32| settings.iter().all(|group| group.number != *number);
    if let Some(number) = written_number.filter(disagrees) {
        let message = format!("the number {number} is not that of the symbol; the symbol is used");
        warnings.add(line, message);
    }
    fitting(&settings, cell, line, warnings)
}

/// What to say of a block that has none of the symmetry that is read: it may have another kind.
fn without_symmetry(block: &Block<'_>) -> Problem {
    if block.has(&MAGNETIC) {
        Problem::Magnetic
    } else if block.has(&MODULATED) {
        Problem::Modulated
    } else {
        Problem::NoSymmetry
    }
}

/// The settings of a Hermann–Mauguin symbol, or of a Schoenflies or Hall symbol in its place.
///
/// Not of a geometric symbol: `P 22` in a file is a slip of the pen for `P 2 2 2`, not number 47.
fn settings(
    text: &str,
    line: usize,
    warnings: &mut Warnings,
) -> Result<Vec<&'static SpaceGroup>, Located> {
    let error = match SpaceGroup::from_symbol(text) {
        Ok(settings) => return Ok(settings),
        Err(error) => error,
    };
    let mut settings = SpaceGroup::from_schoenflies(text);
    settings.extend(SpaceGroup::from_hall(text).filter(|_| settings.is_empty()));
    let Some(group) = settings.first() else {
        return Err(Located::new(line, error.into()));
    };
    let message = format!(
        "`{}` is no Hermann–Mauguin symbol, but another one of {}",
        shortened(text),
        group.symbol
    );
    warnings.add(line, message);
    Ok(settings)
}

/// The symbol with the choice of origin or axes that a remark in braces, as in
/// `R 3 c {rhombohedral axes}`, or another data name may hold.
fn qualified(block: &Block<'_>, symbol: &str) -> String {
    if let Some((symbol, remark)) = symbol.split_once('{') {
        let remark = remark.trim().to_ascii_lowercase();
        let axes = [
            ("rhomb", ":R"),
            ("hex", ":H"),
            ("origin 1", ":1"),
            ("origin 2", ":2"),
        ];
        let chosen = axes.iter().find(|(word, _)| remark.starts_with(word));
        return format!(
            "{}{}",
            symbol.trim(),
            chosen.map_or("", |(_, choice)| choice)
        );
    }
    let code = block
        .first(&COORDINATE_SYSTEM)
        .and_then(|(_, value)| value.known());
    let choice = code
        .and_then(|code| code.chars().next())
        .map(|first| first.to_ascii_lowercase());
    match choice {
        Some(choice @ ('1' | '2' | 'h' | 'r')) if !symbol.contains(':') => {
            let text = format!("{symbol}:{choice}");
            // `1` is also written for groups that have no choice.
            if SpaceGroup::from_symbol(&text).is_ok() {
                text
            } else {
                symbol.to_owned()
            }
        }
        _ => symbol.to_owned(),
    }
}

fn group_number(value: &Value<'_>) -> Result<u32, Located> {
    let text = value.known().unwrap_or_default();
    let number = text
        .parse()
        .ok()
        .filter(|number| (1..=230).contains(number));
    number.ok_or_else(|| {
        let found = text.chars().take(40).collect();
        Located::new(value.line, Problem::Number { found })
    })
}

/// The first setting whose symmetry the cell has; when none fits, the first, so that the misfit is
/// reported for it.
fn fitting(
    settings: &[&'static SpaceGroup],
    cell: &Cell,
    line: usize,
    warnings: &mut Warnings,
) -> Result<Symmetry, Located> {
    let operations = |group: &SpaceGroup| {
        group.operations().map_err(|reason| {
            Located::new(
                line,
                Problem::Hall {
                    text: group.hall.to_owned(),
                    reason,
                },
            )
        })
    };
    let mut chosen = None;
    for group in settings {
        let group_operations = operations(group)?;
        if SymmetricCell::new(&group_operations, cell).is_ok() {
            chosen = Some((*group, group_operations));
            break;
        }
    }
    let (group, operations) = match (chosen, settings.first()) {
        (Some(chosen), _) => chosen,
        (None, Some(group)) => (*group, operations(group)?),
        (None, None) => return Err(Located::new(line, Problem::NoSymmetry)),
    };
    let open_origin = group.choice == Some('2')
        && settings
            .iter()
            .any(|other| other.symbol == group.symbol && other.choice == Some('1'));
    if open_origin {
        let message = format!(
            "{} has two origin choices and the file names none; `{}` is used",
            group.symbol,
            group.qualified_symbol()
        );
        warnings.add(line, message);
    }
    Ok(of_group(group, operations))
}
