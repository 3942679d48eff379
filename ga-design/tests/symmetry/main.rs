//! Whether roots, point groups, lattices and space groups are those of the literature.

mod cell_shapes;
mod generation;
mod geometric_symbols;
mod lattices;
mod point_groups;
mod point_symbols;
mod root_edges;
mod roots;
mod versors;
