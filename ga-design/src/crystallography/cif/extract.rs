//! How a data block becomes a crystal: which block, which name, which cell.

use super::super::cell::Cell;
use super::super::crystal::{Crystal, Measured};
use super::block::Block;
use super::problem::Problem;
use super::token::Value;
use super::{Located, Warnings, number, sites, symmetry};

const EDGES: [&str; 3] = ["_cell_length_a", "_cell_length_b", "_cell_length_c"];
const ANGLES: [&str; 3] = ["_cell_angle_alpha", "_cell_angle_beta", "_cell_angle_gamma"];

/// What the substance is called, the best name first.
const NAMES: [&str; 3] = [
    "_chemical_name_mineral",
    "_chemical_name_common",
    "_chemical_name_systematic",
];

/// The crystal of the first block that has a cell and sites.
pub fn crystal(blocks: &[Block<'_>], warnings: &mut Warnings) -> Result<Crystal, Located> {
    let with_cell = |block: &&Block<'_>| block.has(&EDGES);
    let complete = |block: &&Block<'_>| with_cell(block) && block.has(&sites::COORDINATES);
    let first_line = blocks.first().map_or(1, |block| block.line);
    let Some(block) = blocks.iter().find(complete) else {
        return Err(match blocks.iter().find(with_cell) {
            Some(block) => Located::new(block.line, Problem::NoSites),
            None => Located::new(first_line, Problem::NoCell),
        });
    };
    let (cell, cell_line) = cell(block)?;
    let found = symmetry::symmetry(block, &cell, cell_line, warnings)?;
    let sites = sites::sites(block, &cell, warnings)?;
    Ok(Crystal {
        name: name(block),
        number: found.number,
        hermann_mauguin: found.hermann_mauguin,
        cell,
        operations: found.operations,
        sites,
    })
}

fn name(block: &Block<'_>) -> String {
    let written = block.first(&NAMES).and_then(|(_, value)| value.known());
    let words: Vec<&str> = written.unwrap_or(block.name).split_whitespace().collect();
    words.join(" ").chars().take(100).collect()
}

/// The cell and the line of its first parameter.
fn cell(block: &Block<'_>) -> Result<(Cell, usize), Located> {
    let mut line = block.line;
    let mut edges = [0.0; 3];
    for (edge, tag) in edges.iter_mut().zip(EDGES) {
        let missing = || Located::new(block.line, Problem::MissingCell { tag });
        let (_, value) = block.first(&[tag]).ok_or_else(missing)?;
        *edge = required(tag, &value)?.value;
        if tag == EDGES[0] {
            line = value.line;
        }
    }
    let mut angles = [0.0; 3];
    for (angle, tag) in angles.iter_mut().zip(ANGLES) {
        let missing = || Located::new(block.line, Problem::MissingCell { tag });
        let (_, value) = block.first(&[tag]).ok_or_else(missing)?;
        *angle = required(tag, &value)?.value;
    }
    let cell = Cell::new(edges, angles).map_err(|error| Located::new(line, error.into()))?;
    Ok((cell, line))
}

/// A number that must be there.
pub fn required(tag: &str, value: &Value<'_>) -> Result<Measured, Located> {
    number::measured(value.text).ok_or_else(|| {
        let found = value.text.trim().chars().take(40).collect();
        Located::new(
            value.line,
            Problem::NotANumber {
                tag: tag.to_owned(),
                found,
            },
        )
    })
}
