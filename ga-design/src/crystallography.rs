//! Which parts of crystallography there are, and how a file becomes atoms: text → [`Crystal`] →
//! [`Placement`]s → [`Atom`]s.
//!
//! ```text
//! cif::read_file ──► Crystal { cell, operations, sites } ──► expand ──► Vec<Atom>
//!                      ▲              ▲
//!        hall, symbols ┘              └ Placement: ≤ 3 reflections, then a translation
//!                                       └ Isometry: the same as versors
//!
//! p, q ──► Roots ──► PointGroup             a geometric symbol such as `b(4)2`
//!            └─ lattice, generators ──► SpaceGroup::generate ──► Isometry, Operation
//! ```
//!
//! Beside this way stand the groups themselves: [`SpaceGroup`] by every symbol and setting,
//! [`SubperiodicGroup`] for friezes, wallpapers, rods and layers, [`WyckoffPositions`] for special
//! places, [`Recognition`] of a list of operations, and [`ChangeOfBasis`] between settings.
//!
//! Symmetry is exact (integers and rationals modulo the lattice); only lengths and coordinates
//! are floating point. Fractional coordinates are columns, so an operation `(W, w)` maps `x` to
//! `W x + w`, as in *International Tables for Crystallography*, volume A.
//!
//! ```
//! use ga_design::crystallography::{SpaceGroup, Expansion, cif};
//!
//! let text = "data_halite
//! _cell_length_a 5.6401
//! _cell_length_b 5.6401
//! _cell_length_c 5.6401
//! _cell_angle_alpha 90
//! _cell_angle_beta 90
//! _cell_angle_gamma 90
//! _space_group_name_H-M_alt 'F m -3 m'
//! loop_
//! _atom_site_label
//! _atom_site_fract_x
//! _atom_site_fract_y
//! _atom_site_fract_z
//! Na 0 0 0
//! Cl 0.5 0.5 0.5
//! ";
//! let reading = cif::read_str("halite.cif", text)?;
//! assert_eq!(reading.crystal.number, Some(225));
//! let atoms = Expansion::default().unit_cell(&reading.crystal)?;
//! assert_eq!(atoms.len(), 8);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod bonds;
pub mod cell;
pub mod cell_range;
pub mod change_of_basis;
pub mod cif;
pub mod closure;
pub mod crystal;
mod direction;
pub mod elements;
pub mod fundamental_domain;
pub mod generators;
pub mod hall;
pub mod lattice;
pub mod motif;
pub mod operation;
pub mod overlay;
pub mod placement;
pub mod point_group;
pub mod recognition;
pub mod roots;
pub mod scene;
mod smith;
pub mod subperiodic;
pub mod symbols;
pub mod symmetry_elements;
pub mod unit_cell;
pub mod versor;
pub mod wyckoff;
pub mod xyz;

pub use bonds::{Bond, BondError, Bonding};
pub use cell::{Cell, CellError};
pub use cell_range::{CellRange, CellRangeError};
pub use change_of_basis::{ChangeOfBasis, ChangeOfBasisError};
pub use closure::{ClosureError, close};
pub use crystal::{Crystal, Measured, Site};
pub use elements::Element;
pub use fundamental_domain::{DomainFace, FundamentalDomain, FundamentalDomainError};
pub use generators::{
    DirectionError, ExpressionError, Generation, GenerationError, GeneratorExpression,
    GeometricSymbol, GeometricSymbolError, RootDirection, SpaceGroupGenerators,
};
pub use hall::HallError;
pub use lattice::{
    BravaisLattice, CellParameters, CellShape, Centring, ConstraintError, CrystalSystem,
};
pub use motif::{Coincidence, Curve, Labelled, Motif, MotifCopy, MotifError, Pattern, Strut};
pub use operation::{Operation, OperationError};
pub use placement::{Placement, PlacementError};
pub use point_group::{
    Bars, CrystalClass, PointGroup, PointSymbol, PointSymbolError, Step, UnknownPointGroup, Word,
};
pub use recognition::Recognition;
pub use roots::{Roots, RootsError};
pub use subperiodic::{
    SubperiodicGroup, SubperiodicGroupError, SubperiodicKind, SubperiodicLattice,
    SubperiodicOperation, SubperiodicOperationError, UnknownSubperiodicSymbol,
};
pub use symbols::{SpaceGroup, UnknownSymbol};
pub use symmetry_elements::SymmetryElements;
pub use unit_cell::{Atom, Expansion, ExpansionError};
pub use versor::{Isometry, Motion, Movable, NotOfLattice};
pub use wyckoff::{LocatedSite, SiteCoordinates, WyckoffPosition, WyckoffPositions};
