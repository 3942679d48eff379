//! Whether crystals and space groups are what their files, tables and other programs say.

mod bonds;
mod cif;
mod crystals;
mod files;
mod fundamental_domain;
mod groups;
mod hostile;
mod motif;
mod motion_elements;
mod operations;
mod overlay;
mod shipped;
mod standard_cell;
mod strangers;
mod symmetry_elements;
mod symmetry_symbols;
mod unlisted;
