//! Which groups repeat in fewer directions than space has: 7 frieze, 17 plane (wallpaper), 75 rod
//! and 80 layer groups.
//!
//! Each is a space group in a fitting setting from which the translations across its own are
//! left out, so that the generators of that space group, carried to the setting, generate it. The
//! table `data/subperiodic.tsv` gives Hall symbols: generators, not operations. The conventions
//! are those of *International Tables* A (plane groups) and E (the others): friezes repeat along
//! a, plane and layer groups along a and b, rods along c.

use std::fmt;
use std::sync::LazyLock;

use super::hall::{self, HallError};
use super::recognition::Recognition;
use super::symbols::{CrystalSystem, SpaceGroup, folded};

mod operation;
mod symbol;

pub use operation::{SubperiodicOperation, SubperiodicOperationError};
pub use symbol::UnknownSubperiodicSymbol;

const TABLE: &str = include_str!("../../data/subperiodic.tsv");

/// The four kinds of subperiodic and plane groups.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum SubperiodicKind {
    /// In the plane, repeating along a.
    Frieze,
    /// In the plane, repeating along a and b: the wallpaper groups.
    Plane,
    /// In space, repeating along c.
    Rod,
    /// In space, repeating along a and b.
    Layer,
}

impl SubperiodicKind {
    /// All four.
    pub const ALL: [Self; 4] = [Self::Frieze, Self::Plane, Self::Rod, Self::Layer];

    /// How many types of groups there are: 7, 17, 75, 80.
    pub fn count(self) -> u32 {
        match self {
            Self::Frieze => 7,
            Self::Plane => 17,
            Self::Rod => 75,
            Self::Layer => 80,
        }
    }

    /// The dimension of the space that the group acts on: 2 or 3.
    pub fn dimension(self) -> usize {
        match self {
            Self::Frieze | Self::Plane => 2,
            Self::Rod | Self::Layer => 3,
        }
    }

    /// Along which of the axes a, b, c there are translations.
    pub fn periodic(self) -> [bool; 3] {
        match self {
            Self::Frieze => [true, false, false],
            Self::Plane | Self::Layer => [true, true, false],
            Self::Rod => [false, false, true],
        }
    }

    /// The number of independent translations: 1 or 2.
    pub fn rank(self) -> usize {
        self.periodic().into_iter().filter(|along| *along).count()
    }

    pub(super) fn read(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|kind| kind.to_string() == name)
    }
}

/// `frieze`, `plane`, `rod` or `layer`.
impl fmt::Display for SubperiodicKind {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(match self {
            Self::Frieze => "frieze",
            Self::Plane => "plane",
            Self::Rod => "rod",
            Self::Layer => "layer",
        })
    }
}

/// The lattice of the translations.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum SubperiodicLattice {
    /// One translation: rods and friezes.
    Line,
    /// Any two translations.
    Oblique,
    /// Two translations at a right angle.
    Rectangular,
    /// The same, with another to the middle of the cell.
    CentredRectangular,
    /// Two equal translations at a right angle.
    Square,
    /// Two equal translations at 120°.
    Hexagonal,
}

/// `oblique p`, `rectangular c` and so on, as International Tables name them.
impl fmt::Display for SubperiodicLattice {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(match self {
            Self::Line => "line p",
            Self::Oblique => "oblique p",
            Self::Rectangular => "rectangular p",
            Self::CentredRectangular => "rectangular c",
            Self::Square => "square p",
            Self::Hexagonal => "hexagonal p",
        })
    }
}

/// One setting of a frieze, plane, rod or layer group.
///
/// ```
/// use ga_design::crystallography::{SubperiodicGroup, SubperiodicKind};
///
/// let wallpaper = &SubperiodicGroup::from_symbol(SubperiodicKind::Plane, "p4gm")?[0];
/// assert_eq!((wallpaper.number, wallpaper.point_group()), (12, Some("4mm")));
/// let operations = wallpaper.operations().unwrap_or_default();
/// assert_eq!(operations.len(), 8);
/// assert!(operations.iter().any(|operation| operation.to_string() == "y+1/2,x+1/2"));
/// # Ok::<(), ga_design::crystallography::UnknownSubperiodicSymbol>(())
/// ```
#[derive(Debug, PartialEq, Eq)]
pub struct SubperiodicGroup {
    /// Frieze, plane, rod or layer.
    pub kind: SubperiodicKind,
    /// The number in International Tables, from 1.
    pub number: u32,
    /// The Hermann–Mauguin symbol with blanks, such as `p 4/n b m`.
    pub symbol: &'static str,
    /// The origin choice `1` or `2`, where there are two.
    pub choice: Option<char>,
    /// The Hall symbol of the space group that has translations along all axes as well.
    pub hall: &'static str,
    /// Whether this is the setting that the number alone stands for.
    pub standard: bool,
    full: &'static str,
    /// Other spellings: old symbols, orbifold symbols of the plane groups.
    also: Vec<&'static str>,
}

impl SubperiodicGroup {
    /// All known settings, by kind and number.
    pub fn table() -> &'static [Self] {
        &GROUPS
    }

    /// The standard setting of a number.
    pub fn standard(kind: SubperiodicKind, number: u32) -> Option<&'static Self> {
        let mut groups = Self::table().iter();
        groups.find(|group| (group.kind, group.number, group.standard) == (kind, number, true))
    }

    /// All settings of a number, the standard one first.
    pub fn settings(kind: SubperiodicKind, number: u32) -> Vec<&'static Self> {
        let mut found: Vec<_> = Self::table()
            .iter()
            .filter(|group| (group.kind, group.number) == (kind, number))
            .collect();
        found.sort_by_key(|group| !group.standard);
        found
    }

    /// The settings that a symbol may mean, the standard one first: Hermann–Mauguin, short
    /// (`p m`) or full (`p 1 m 1`), old (`p 4 g`), with `:1` or `:2` for the origin, for plane
    /// groups also orbifold symbols (`4*2`); or a number.
    pub fn from_symbol(
        kind: SubperiodicKind,
        symbol: &str,
    ) -> Result<Vec<&'static Self>, UnknownSubperiodicSymbol> {
        symbol::find(kind, symbol)
    }

    /// The full symbol: `p 21/b 21/m 2/a` for `p b m a`, `p 1 m 1` for `p m`.
    pub fn full_symbol(&self) -> &'static str {
        if self.full.is_empty() {
            self.symbol
        } else {
            self.full
        }
    }

    /// The symbol with its choice of origin where there is one: `p 4/n:2`.
    pub fn qualified_symbol(&self) -> String {
        match self.choice {
            Some(choice) => format!("{}:{choice}", self.symbol),
            None => self.symbol.to_owned(),
        }
    }

    /// The operations modulo the translations of the group, the identity first.
    pub fn operations(&self) -> Result<Vec<SubperiodicOperation>, SubperiodicGroupError> {
        hall::operations(self.hall)?
            .iter()
            .map(|operation| Ok(SubperiodicOperation::new(self.kind, *operation)?))
            .collect()
    }

    /// The space group that has translations along all axes as well, and the change of basis from
    /// its standard setting: it carries the generators of the space group to generators of this
    /// group.
    pub fn space_group(&self) -> Option<Recognition> {
        SpaceGroup::recognise(&hall::operations(self.hall).ok()?)
    }

    /// The point group, such as `4/mmm`; in the plane one of 1, 2, m, 2mm, 3, 3m, 4, 4mm, 6, 6mm.
    pub fn point_group(&self) -> Option<&'static str> {
        let space_group = SpaceGroup::standard(self.space_group()?.number)?;
        match (self.kind.dimension(), space_group.point_group) {
            (2, "mm2") => Some("2mm"),
            (_, name) => Some(name),
        }
    }

    /// The crystal system; in the plane, where an oblique lattice has at most rotations by 180°
    /// and a rectangular one mirrors, the system of the layer with the same operations.
    pub fn crystal_system(&self) -> CrystalSystem {
        use CrystalSystem::{
            Cubic, Hexagonal, Monoclinic, Orthorhombic, Tetragonal, Triclinic, Trigonal,
        };
        // The last number of each system, in the order of the systems.
        let last = match self.kind {
            SubperiodicKind::Frieze => [1, 5, 7, 7, 7, 7],
            SubperiodicKind::Plane => [1, 5, 9, 12, 15, 17],
            SubperiodicKind::Rod => [2, 12, 22, 41, 52, 75],
            SubperiodicKind::Layer => [2, 18, 48, 64, 72, 80],
        };
        [
            Triclinic,
            Monoclinic,
            Orthorhombic,
            Tetragonal,
            Trigonal,
            Hexagonal,
        ]
        .into_iter()
        .zip(last)
        .find(|(_, last)| self.number <= *last)
        .map_or(Cubic, |(system, _)| system)
    }

    /// The lattice of the translations.
    pub fn lattice(&self) -> SubperiodicLattice {
        let oblique = match self.kind {
            SubperiodicKind::Frieze | SubperiodicKind::Rod => return SubperiodicLattice::Line,
            SubperiodicKind::Plane => self.number <= 2,
            SubperiodicKind::Layer => self.number <= 7,
        };
        match self.crystal_system() {
            _ if oblique => SubperiodicLattice::Oblique,
            CrystalSystem::Tetragonal => SubperiodicLattice::Square,
            CrystalSystem::Trigonal | CrystalSystem::Hexagonal => SubperiodicLattice::Hexagonal,
            _ if self.symbol.starts_with('c') => SubperiodicLattice::CentredRectangular,
            _ => SubperiodicLattice::Rectangular,
        }
    }

    /// Every spelling, folded.
    fn spellings(&self) -> Vec<String> {
        let own = [self.symbol, self.full_symbol()];
        own.iter()
            .chain(&self.also)
            .map(|name| folded(name))
            .collect()
    }
}

/// Why a row of the table makes no group; never for the rows there are.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum SubperiodicGroupError {
    /// The Hall symbol cannot be read.
    #[error(transparent)]
    Hall(#[from] HallError),
    /// An operation leaves the line or layer.
    #[error(transparent)]
    Operation(#[from] SubperiodicOperationError),
}

static GROUPS: LazyLock<Vec<SubperiodicGroup>> =
    LazyLock::new(|| TABLE.lines().filter_map(row).collect());

/// A row of the table; `None` for its heading.
fn row(line: &'static str) -> Option<SubperiodicGroup> {
    let mut fields = line.split('\t');
    Some(SubperiodicGroup {
        kind: SubperiodicKind::read(fields.next()?)?,
        number: fields.next()?.parse().ok()?,
        symbol: fields.next()?,
        full: fields.next()?,
        hall: fields.next()?,
        standard: fields.next()? == "standard",
        also: fields
            .next()?
            .split("; ")
            .filter(|name| !name.is_empty())
            .collect(),
        choice: fields.next()?.chars().next(),
    })
}
