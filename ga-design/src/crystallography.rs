//! Which parts of crystallography there are, in the terms of *International Tables for
//! Crystallography*: from three root vectors to every group, and from a file to its atoms.
//!
//! ```text
//!  p, q ─► Roots a, b, c ─► PointGroup                      symbols: 43, b(4)2, m-3m, Oh
//!              │                 │ order, classes
//!              │        CellParameters ─► Cell ─► edges     BravaisLattice, Centring
//!              └───────┬─────────┘
//!                      ▼
//!  SpaceGroupGenerators ─► SpaceGroup::generate ─► Generation: versors + operations
//!                      ▲                                 │
//!  number, symbol ─► SpaceGroup::find          ┌─────────┼───────────────┐
//!  operations ─► SpaceGroup::recognise         ▼         ▼               ▼
//!       └─► number + ChangeOfBasis      WyckoffPositions │        SubperiodicGroup
//!                                                        ▼
//!  CIF text ─► cif ─► Crystal { cell, operations, sites } ─► Placement ─► Atoms
//! ```
//!
//! # 1. Roots
//!
//! Two mirrors at the angle π/p make a rotation by 2π/p. [`Roots`] are three unit vectors, the
//! normals of mirrors: **a** and **b** at π/p, **b** and **c** at π/q, **c** and **a** at a right
//! angle. They exist when 1/p + 1/q > 1/2 (or p = 1 fits), crystal or not.
//!
//! ```
//! use ga_design::crystallography::Roots;
//!
//! assert!(Roots::new(5, 3).is_ok()); // the icosahedron
//! assert!(Roots::new(4, 5).unwrap_err().to_string().contains("do not close"));
//! ```
//!
//! # 2. Point groups
//!
//! A [`PointGroup`] consists of words in the roots. Its geometric symbol `pq` has the mirrors **a**,
//! **b**, **c** as generators; a bar, written `b(p)`, leaves their product only: `b(4)2` has the
//! rotation **ab** and the mirror **c**. 32 of them leave a lattice in place: the [`CrystalClass`]es.
//!
//! ```
//! use ga_design::crystallography::PointGroup;
//!
//! let cube = PointGroup::from_geometric("43")?;
//! assert_eq!((cube.order(), cube.crystal_class().map(|class| class.international)), (48, Some("m-3m")));
//! # Ok::<(), ga_design::crystallography::PointSymbolError>(())
//! ```
//!
//! # 3. Lattices
//!
//! A lattice is seen through a [`Cell`] with edges a, b, c. [`CellParameters`] holds what a
//! [`CrystalSystem`] leaves free, [`CellShape::check`] names the constraint that a cell breaks, and
//! a [`Centring`] P, A, B, C, F, I or R puts further points into it: the 14 [`BravaisLattice`]s.
//!
//! ```
//! use ga_design::crystallography::{CellParameters, CellShape};
//!
//! let cell = CellParameters::Tetragonal { a: 4.594, c: 2.959 }.cell()?;
//! let error = CellShape::Cubic.check(&cell).unwrap_err();
//! assert_eq!(error.to_string(), "cubic needs b = c; here b = 4.594, c = 2.959");
//! # Ok::<(), ga_design::crystallography::CellError>(())
//! ```
//!
//! # 4. Space groups
//!
//! A root joined to a fraction of an edge becomes a glide, a product of two of them a screw: all
//! 230 [`SpaceGroup`]s grow from generators such as `T_c^{1/2} ab` by composition modulo the
//! lattice. Each element is a versor ([`Isometry`]) that moves any multivector, and at the same time
//! an exact [`Operation`] `(W, w)`: fractional coordinates are columns, `x ↦ W x + w`. Hall symbols
//! ([`hall`]) make the operations a second way, without any roots, and each way tests the other.
//!
//! ```
//! use ga_design::crystallography::{CellParameters, SpaceGroup};
//!
//! let group = SpaceGroup::find("P 41 2 2")?[0];
//! let cell = CellParameters::Tetragonal { a: 5.0, c: 12.0 }.cell()?;
//! let grown = group.generate(&cell)?;
//! assert_eq!(grown.representatives().len(), 8);
//! assert!(grown.operations().contains(&"-y,x,z+1/4".parse()?));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # 5. Settings
//!
//! One group has many descriptions: unique axes, cell choices, origins 1 and 2, hexagonal (`:H`) or
//! rhombohedral (`:R`) axes. [`SpaceGroup::find`] reads numbers, Hermann–Mauguin, Schoenflies, Hall
//! and geometric symbols; a [`ChangeOfBasis`] `(P, p)` leads from one setting to another; and
//! [`SpaceGroup::recognise`] tells the group of operations in a setting that no table lists.
//!
//! ```
//! use ga_design::crystallography::{Operation, SpaceGroup, close};
//!
//! assert_eq!(SpaceGroup::find("P2₁/n")?[0].symbol, "P 1 21/n 1");
//! // An inversion away from the origin.
//! let inversion: Operation = "1/5-x,-y,-z".parse()?;
//! let found = SpaceGroup::recognise(&close(&[inversion])?);
//! assert_eq!(found.map(|found| found.number), Some(2));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # 6. Positions
//!
//! The points that an operation keeps are special: fewer copies, more symmetry.
//! [`WyckoffPositions`] lists them with multiplicity, letter and site symmetry, and
//! [`WyckoffPositions::locate`] snaps a point to the most special one nearby.
//!
//! ```
//! use ga_design::crystallography::WyckoffPositions;
//!
//! let halite = WyckoffPositions::standard(225);
//! let sodium = halite.as_ref().and_then(|all| all.position('a'));
//! assert_eq!(sodium.map(|p| (p.symbol(), p.site_symmetry.as_str())), Some(("4a".into(), "m-3m")));
//! ```
//!
//! # 7. Subperiodic groups
//!
//! A [`SubperiodicGroup`] repeats in fewer directions than the space has: 7 frieze, 17 plane
//! (wallpaper), 75 rod and 80 layer groups, with settings and positions as above.
//!
//! ```
//! use ga_design::crystallography::{SubperiodicGroup, SubperiodicKind};
//!
//! let found = SubperiodicGroup::from_symbol(SubperiodicKind::Plane, "p 6 m m")?;
//! let positions = found[0].wyckoff_positions().unwrap_or_default();
//! let symbols: Vec<String> = positions.iter().map(|position| position.symbol()).collect();
//! assert_eq!(symbols.join(" "), "1a 2b 3c 6d 6e 12f");
//! # Ok::<(), ga_design::crystallography::UnknownSubperiodicSymbol>(())
//! ```
//!
//! # 8. Symmetry elements
//!
//! What operations leave in place: axes with their screws, mirror and glide planes, inversion
//! centres. [`SymmetryElements`] finds them exactly, [`overlay`] draws them, and what they enclose
//! is a [`FundamentalDomain`], the part of the cell that the group repeats.
//!
//! ```
//! use ga_design::crystallography::{FundamentalDomain, SpaceGroup, SymmetryElements};
//!
//! let group = SpaceGroup::find("P 21/c")?[0];
//! let operations = group.operations()?;
//! let elements = SymmetryElements::of(&operations)?;
//! assert_eq!(elements.axes()[0].to_string(), "2_1");
//! assert_eq!((elements.planes()[0].letter(), elements.centres().len()), ('c', 8));
//! let cell = group.cell_shape().example().cell()?;
//! let domain = FundamentalDomain::of(&operations, &cell)?;
//! assert!((4.0 * domain.volume() - cell.volume()).abs() < 1e-9 * cell.volume());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # 9. Motifs
//!
//! A [`Pattern`] carries any [`Motif`] through a group and a block of cells: points,
//! circles, motors or whichever multivector, curves, struts and meshes. Copies that coincide, as those
//! in special position do, are one.
//!
//! ```
//! use ga_cga::{DualSphere, Vector3};
//! use ga_design::crystallography::{Cell, CellRange, Coincidence, Pattern, SpaceGroup};
//!
//! let cell = Cell::new([4.0; 3], [90.0; 3])?;
//! let group = SpaceGroup::find("I m -3 m")?[0];
//! let pattern = Pattern::of_group(&group.operations()?, &cell, CellRange::UNIT)?;
//! let ball = DualSphere::with_radius(Vector3::new(0.0, 0.0, 0.0), 1.0);
//! let when = Coincidence::default();
//! // At the corners of the cells and in their middles.
//! assert_eq!(pattern.gathered(ball.center().unwrap_or_default()).distinct(&ball, &when)?.len(), 2);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # 10. Crystals
//!
//! A [`Crystal`] is a cell, its operations and the sites that differ by more than symmetry;
//! [`Expansion`] places all their copies, [`Bonding`] joins them. Symmetry is exact (integers and
//! rationals modulo the lattice); only lengths and coordinates are floating point.
//!
//! ```
//! use ga_design::crystallography::{Expansion, cif};
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

pub mod asymmetric;
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
pub mod general_position;
pub mod generators;
pub mod hall;
pub mod lattice;
pub mod motif;
pub mod operation;
pub mod overlay;
pub mod placement;
pub mod plane_pattern;
pub mod point_group;
pub mod recognition;
pub mod roots;
pub mod scene;
mod smith;
pub mod subperiodic;
mod symbol_reader;
pub mod symbols;
mod symmetry_directions;
pub mod symmetry_elements;
pub mod unit_cell;
pub mod versor;
pub mod wyckoff;
pub mod xyz;

pub use asymmetric::{AsymmetricMotif, comma_outline};
pub use bonds::{Bond, BondError, Bonding};
pub use cell::{Cell, CellError};
pub use cell_range::{CellRange, CellRangeError};
pub use change_of_basis::{ChangeOfBasis, ChangeOfBasisError};
pub use closure::{ClosureError, close};
pub use crystal::{Crystal, Measured, Site};
pub use elements::Element;
pub use fundamental_domain::{DomainFace, FundamentalDomain, FundamentalDomainError};
pub use general_position::{GeneralPosition, general_position};
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
pub use plane_pattern::{PlanePattern, PlanePatternError};
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
pub use wyckoff::{
    LocatedSite, SiteCoordinates, SubperiodicPosition, WyckoffPosition, WyckoffPositions,
};
