//! A cell for each group.

use ga_design::crystallography::Cell;

/// A cell that a group of this number can have in its standard setting.
pub fn cell(number: u32) -> Cell {
    let (edges, angles) = match number {
        1..=2 => ([5.1, 6.2, 7.3], [82.0, 97.0, 104.0]),
        3..=15 => ([5.1, 6.2, 7.3], [90.0, 104.0, 90.0]),
        16..=74 => ([5.1, 6.2, 7.3], [90.0; 3]),
        75..=142 => ([5.1, 5.1, 7.3], [90.0; 3]),
        143..=194 => ([5.1, 5.1, 7.3], [90.0, 90.0, 120.0]),
        _ => ([5.1; 3], [90.0; 3]),
    };
    Cell::new(edges, angles).expect("a cell")
}
