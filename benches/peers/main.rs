//! The same operations on the same data, in one process, by this library and by those that one
//! would take instead. `cargo bench --bench peers` prints a table for each build.
//!
//! Left out, because they do not do it at speed or do not build: `g3` (nightly compiler only),
//! `geonum` (numbers with angles, another representation), `cga` and `pga` (names without code).

mod conformal;
mod data;
mod euclidean;
mod others;
mod ours;
mod plane_based;
mod table;

use table::Table;

fn main() {
    let mut table = Table::default();
    euclidean::run(&mut table);
    plane_based::run(&mut table);
    conformal::run(&mut table);
    print!("{table}");
}
