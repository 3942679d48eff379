//! Which places of a cell are special, and what they are called: the Wyckoff positions of every
//! space group in every setting.
//!
//! Letters and first representatives are facts of *International Tables* A and stand in
//! `data/wyckoff.tsv` for the standard settings. Everything else follows from the operations: the
//! site-symmetry group keeps the representative, its cosets give the other triplets and their
//! number the multiplicity, and a change of basis carries all to other settings.

use std::collections::{HashMap, HashSet};
use std::sync::LazyLock;

use super::change_of_basis::ChangeOfBasis;
use super::operation::Operation;
use super::symbols::SpaceGroup;

mod coordinates;
mod nearest;
mod site_symmetry;
mod subperiodic;

pub use coordinates::SiteCoordinates;
pub use nearest::LocatedSite;
pub use subperiodic::SubperiodicPosition;

const TABLE: &str = include_str!("../../data/wyckoff.tsv");

/// A Wyckoff position: the points of space with site-symmetry groups that are conjugate.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct WyckoffPosition {
    /// The letter of *International Tables*, `a` for the highest site symmetry; `A` follows `z`
    /// in group 47, where the tables print α.
    pub letter: char,
    /// The number of points per cell.
    pub multiplicity: usize,
    /// The oriented symbol of the site symmetry, such as `.3m`.
    pub site_symmetry: String,
    coordinates: Vec<SiteCoordinates>,
    /// Of each triplet, a basis of the integer normals.
    normals: Vec<Vec<[i32; 3]>>,
    site_group: Vec<Operation>,
}

impl WyckoffPosition {
    /// The triplets, the representative of the tables first: as many as the multiplicity.
    pub fn coordinates(&self) -> &[SiteCoordinates] {
        &self.coordinates
    }

    /// The first triplet.
    pub fn representative(&self) -> SiteCoordinates {
        // Never empty: the identity gives the first.
        self.coordinates
            .first()
            .copied()
            .unwrap_or(SiteCoordinates::GENERAL)
    }

    /// The number of free variables: 0 for points, 1 for lines, 2 for planes, 3 for the general
    /// position.
    pub fn dimension(&self) -> usize {
        self.representative().dimension()
    }

    /// The operations (modulo the lattice) that keep every point of the representative.
    pub fn site_group(&self) -> &[Operation] {
        &self.site_group
    }

    /// The symbol of multiplicity and letter, such as `4a`.
    pub fn symbol(&self) -> String {
        format!("{}{}", self.multiplicity, self.letter)
    }
}

/// All Wyckoff positions of a space group in one setting.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct WyckoffPositions {
    positions: Vec<WyckoffPosition>,
}

impl WyckoffPositions {
    /// Of the standard setting of a number from 1 to 230.
    ///
    /// ```
    /// use ga_design::crystallography::WyckoffPositions;
    ///
    /// let diamond = WyckoffPositions::standard(227);
    /// let names: Option<Vec<String>> =
    ///     diamond.map(|all| all.positions().iter().map(|p| p.symbol()).collect());
    /// assert_eq!(names.map(|all| all.join(" ")).as_deref(),
    ///     Some("8a 8b 16c 16d 32e 48f 96g 96h 192i"));
    /// ```
    pub fn standard(number: u32) -> Option<Self> {
        Self::in_setting(number, &ChangeOfBasis::identity())
    }

    /// Of a setting of the table.
    pub fn of(group: &SpaceGroup) -> Option<Self> {
        Self::in_setting(group.number, &group.from_standard()?)
    }

    /// Of the setting that a change of basis makes of the standard one.
    ///
    /// `None` when there is no such number, or the new cell is none of the group (see
    /// [`ChangeOfBasis::operations`]).
    pub fn in_setting(number: u32, change: &ChangeOfBasis) -> Option<Self> {
        let group = SpaceGroup::standard(number)?;
        let standard = group.operations().ok()?;
        let operations = if *change == ChangeOfBasis::identity() {
            standard
        } else {
            change.operations(&standard)?
        };
        let mut positions = Vec::new();
        for row in ROWS.get(&number)? {
            let representative = row.representative.carried(change)?;
            positions.push(row.position(representative, &operations, group, change)?);
        }
        Some(Self { positions })
    }

    /// The positions in the order of their letters: `a` first, the general position last.
    pub fn positions(&self) -> &[WyckoffPosition] {
        &self.positions
    }

    /// The position with a letter.
    pub fn position(&self, letter: char) -> Option<&WyckoffPosition> {
        self.positions
            .iter()
            .find(|position| position.letter == letter)
    }
}

impl SpaceGroup {
    /// The Wyckoff positions in this setting.
    pub fn wyckoff_positions(&self) -> Option<WyckoffPositions> {
        WyckoffPositions::of(self)
    }
}

/// What the tables say; the rest is computed.
struct Row {
    letter: char,
    representative: SiteCoordinates,
}

static ROWS: LazyLock<HashMap<u32, Vec<Row>>> = LazyLock::new(|| {
    let mut rows: HashMap<u32, Vec<Row>> = HashMap::new();
    for line in TABLE.lines() {
        if let Some((number, row)) = Row::read(line) {
            rows.entry(number).or_default().push(row);
        }
    }
    rows
});

impl Row {
    /// A row of the table; `None` for its heading. The columns of multiplicity and site symmetry
    /// are what tests compare with.
    fn read(line: &str) -> Option<(u32, Self)> {
        let mut fields = line.split('\t');
        let number = fields.next()?.parse().ok()?;
        let letter = fields.next()?.chars().next()?;
        let representative = SiteCoordinates::read(fields.nth(2)?)?;
        Some((
            number,
            Self {
                letter,
                representative,
            },
        ))
    }

    fn position(
        &self,
        representative: SiteCoordinates,
        operations: &[Operation],
        group: &SpaceGroup,
        change: &ChangeOfBasis,
    ) -> Option<WyckoffPosition> {
        let mut site_group = Vec::new();
        let mut coordinates = Vec::new();
        let mut seen = HashSet::new();
        for operation in operations {
            let image = representative.image(operation);
            if image == representative {
                site_group.push(*operation);
            }
            if seen.insert(image) {
                coordinates.push(image);
            }
        }
        Some(WyckoffPosition {
            letter: self.letter,
            multiplicity: coordinates.len(),
            site_symmetry: oriented_symbol(&site_group, group, change)?,
            normals: coordinates
                .iter()
                .map(SiteCoordinates::normals)
                .collect::<Option<_>>()?,
            coordinates,
            site_group,
        })
    }
}

/// The symbol on the axes of the setting where the group has its symmetry directions there, and
/// on those of the standard setting otherwise.
///
/// So `2..` becomes `.2.` when the axes of an orthorhombic group are exchanged, while on
/// rhombohedral axes the symbols stay those of the hexagonal ones.
fn oriented_symbol(
    site_group: &[Operation],
    group: &SpaceGroup,
    change: &ChangeOfBasis,
) -> Option<String> {
    use super::symbols::CrystalSystem::{Orthorhombic, Tetragonal};
    let system = group.crystal_system();
    let rhombohedral = group.symbol.starts_with('R');
    let own = || match system {
        Orthorhombic | Tetragonal => site_symmetry::symbol(site_group, system, rhombohedral),
        _ => None,
    };
    let standard = || {
        let back = change.inverse();
        let carried: Option<Vec<Operation>> = site_group
            .iter()
            .map(|operation| back.operation(operation))
            .collect();
        site_symmetry::symbol(&carried?, system, rhombohedral)
    };
    own().or_else(standard)
}
