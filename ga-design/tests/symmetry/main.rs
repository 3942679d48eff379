//! Whether roots, point groups, lattices and space groups are those of the literature.

mod generation;
mod geometric_symbols;
mod lattices;
mod point_groups;
mod point_symbols;
mod roots;
mod versors;
