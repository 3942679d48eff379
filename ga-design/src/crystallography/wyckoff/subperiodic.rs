//! Which places of frieze, plane, rod and layer groups are special.
//!
//! Across the translations of such a group an operation moves nothing, so that what it keeps
//! passes through the origin there. Its positions are therefore those of the space group with
//! translations along all axes that lie at exactly zero across, with the same site symmetry and
//! multiplicity. Letters are no consequence of the operations: for plane groups (*International
//! Tables* A, chapter 2.2) and layer groups (E, part 4) they stand in
//! `data/subperiodic_wyckoff.tsv`.

use std::collections::HashMap;
use std::sync::LazyLock;

use super::super::change_of_basis::ChangeOfBasis;
use super::super::hall;
use super::super::operation::Operation;
use super::super::subperiodic::{SubperiodicGroup, SubperiodicKind, SubperiodicLattice};
use super::super::symbols::{CrystalSystem, SpaceGroup};
use super::{Row, SiteCoordinates, WyckoffPosition, WyckoffPositions, site_symmetry};

const TABLE: &str = include_str!("../../../data/subperiodic_wyckoff.tsv");

/// A Wyckoff position of a frieze, plane, rod or layer group.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SubperiodicPosition {
    /// The letter of *International Tables*, `a` for the highest site symmetry; `None` for
    /// friezes, rods and settings of plane groups other than the standard ones.
    pub letter: Option<char>,
    /// The number of points per cell, or per period of a frieze or rod.
    pub multiplicity: usize,
    /// The oriented symbol of the site symmetry: in the plane of the point, then along the two
    /// kinds of directions, such as `2mm` or `.m.`.
    pub site_symmetry: String,
    kind: SubperiodicKind,
    position: WyckoffPosition,
}

impl SubperiodicGroup {
    /// The Wyckoff positions, those of the highest site symmetry first and the general one last;
    /// where no letters are known, in the order of the space group's.
    ///
    /// `None` for no group of the table.
    ///
    /// ```
    /// use ga_design::crystallography::{SubperiodicGroup, SubperiodicKind};
    ///
    /// let wallpaper = SubperiodicGroup::standard(SubperiodicKind::Plane, 12);
    /// let positions = wallpaper.and_then(|group| group.wyckoff_positions()).unwrap_or_default();
    /// let lines: Vec<String> = positions
    ///     .iter()
    ///     .map(|p| format!("{} {} {}", p.symbol(), p.site_symmetry, p.triplets().join("; ")))
    ///     .collect();
    /// assert_eq!(lines[0], "2a 4.. 0,0; 1/2,1/2");
    /// assert_eq!(lines[1], "2b 2.mm 1/2,0; 0,1/2");
    /// ```
    pub fn wyckoff_positions(&self) -> Option<Vec<SubperiodicPosition>> {
        let found = self.space_group()?;
        let change = &found.from_standard;
        let Some(rows) = ROWS.get(&(self.kind, self.qualified_symbol())) else {
            return self.without_letters(found.number, change);
        };
        let space_group = SpaceGroup::standard(found.number)?;
        let operations = hall::operations(self.hall).ok()?;
        rows.iter()
            .map(|row| {
                let place = row.representative;
                let position = row.position(place, &operations, space_group, change)?;
                self.position(position, Some(row.letter))
            })
            .collect()
    }

    /// The positions of the space group that lie at zero across the translations.
    fn without_letters(
        &self,
        number: u32,
        change: &ChangeOfBasis,
    ) -> Option<Vec<SubperiodicPosition>> {
        let periodic = self.kind.periodic();
        let within = |position: &WyckoffPosition| {
            let shift = position.representative().shift();
            let mut parts = periodic.into_iter().zip(shift);
            parts.all(|(along, part)| along || *part.numer() == 0)
        };
        let all = WyckoffPositions::in_setting(number, change)?;
        let special = all.positions.into_iter().filter(within);
        special
            .map(|position| self.position(position, None))
            .collect()
    }

    fn position(
        &self,
        position: WyckoffPosition,
        letter: Option<char>,
    ) -> Option<SubperiodicPosition> {
        let square = matches!(
            self.lattice(),
            SubperiodicLattice::Square | SubperiodicLattice::Hexagonal
        );
        let site_symmetry = match self.kind.dimension() {
            2 if !square => {
                let symbol = rectangular_symbol(&position.site_group)?;
                // Oblique groups have no directions.
                let oblique = self.number <= 2;
                if oblique {
                    symbol.replace('.', "")
                } else {
                    symbol
                }
            }
            _ => position.site_symmetry.clone(),
        };
        Some(SubperiodicPosition {
            letter,
            multiplicity: position.multiplicity,
            site_symmetry,
            kind: self.kind,
            position,
        })
    }
}

impl SubperiodicPosition {
    /// The places, as many as the multiplicity; in the plane their third coordinate is free.
    pub fn coordinates(&self) -> &[SiteCoordinates] {
        self.position.coordinates()
    }

    /// The coordinates as text: `x,y` in the plane and `x,y,z` in space.
    pub fn triplets(&self) -> Vec<String> {
        let flat = self.kind.dimension() == 2;
        let shown = |place: &SiteCoordinates| {
            let text = place.to_string();
            match text.strip_suffix(",z") {
                Some(shorter) if flat => shorter.to_owned(),
                _ => text,
            }
        };
        self.coordinates().iter().map(shown).collect()
    }

    /// The number of free variables: 0 for points, 1 for lines, 2 for planes, 3 for all of space.
    pub fn dimension(&self) -> usize {
        let across = 3 - self.kind.dimension();
        self.position.dimension().saturating_sub(across)
    }

    /// The operations of the space group with translations along all axes that keep every point
    /// of the first place.
    pub fn site_group(&self) -> &[Operation] {
        self.position.site_group()
    }

    /// Multiplicity and letter, such as `4a`; `4` without a letter.
    pub fn symbol(&self) -> String {
        let letter = self.letter.map(String::from).unwrap_or_default();
        format!("{}{letter}", self.multiplicity)
    }
}

/// The symbol in the order of the plane: about the point, then across `[10]`, then across `[01]`.
fn rectangular_symbol(site_group: &[Operation]) -> Option<String> {
    // The axis c becomes the first one.
    let cycle: ChangeOfBasis = "y,z,x".parse().ok()?;
    let turned: Option<Vec<Operation>> = site_group
        .iter()
        .map(|operation| cycle.operation(operation))
        .collect();
    site_symmetry::symbol(&turned?, CrystalSystem::Orthorhombic, false)
}

/// The rows of a kind and a symbol with its choice of origin.
type Rows = HashMap<(SubperiodicKind, String), Vec<Row>>;

static ROWS: LazyLock<Rows> = LazyLock::new(|| {
    let mut rows = Rows::new();
    for line in TABLE.lines() {
        if let Some((key, row)) = row(line) {
            rows.entry(key).or_default().push(row);
        }
    }
    rows
});

/// A row of the table; `None` for its heading.
fn row(line: &str) -> Option<((SubperiodicKind, String), Row)> {
    let mut fields = line.split('\t');
    let kind = SubperiodicKind::read(fields.next()?)?;
    let symbol = fields.next()?.to_owned();
    let letter = fields.next()?.chars().next()?;
    let representative = SiteCoordinates::read(fields.next()?)?;
    let row = Row {
        letter,
        representative,
    };
    Some(((kind, symbol), row))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn summary(positions: &[SubperiodicPosition]) -> Vec<(usize, usize, String)> {
        let mut all: Vec<_> = positions
            .iter()
            .map(|p| (p.multiplicity, p.dimension(), p.site_symmetry.clone()))
            .collect();
        all.sort();
        all
    }

    #[test]
    fn the_printed_positions_are_those_of_the_space_groups_at_zero_across() {
        let mut compared = 0;
        for group in SubperiodicGroup::table() {
            if !ROWS.contains_key(&(group.kind, group.qualified_symbol())) {
                continue;
            }
            compared += 1;
            let found = group.space_group().expect("a group");
            let computed = group.without_letters(found.number, &found.from_standard);
            let printed = group.wyckoff_positions().expect("a group");
            let name = group.qualified_symbol();
            assert_eq!(
                summary(&printed),
                summary(&computed.expect("a group")),
                "{name}"
            );
        }
        // Every row belongs to a group: 17 plane groups and 116 settings of layer groups.
        assert_eq!((compared, ROWS.len()), (133, 133));
    }
}
