//! Which families a space group belongs to: crystal system, Laue class, lattice centring,
//! Schoenflies symbol.

use super::SpaceGroup;
use crate::crystallography::CrystalSystem;

/// The point groups with what belongs to them (*International Tables* A, table 3.2.1.3), in the
/// order of the space-group numbers: last number, Schoenflies symbol, Laue class.
const CLASSES: [(u32, &str, &str); 32] = [
    (1, "C1", "-1"),
    (2, "Ci", "-1"),
    (5, "C2", "2/m"),
    (9, "Cs", "2/m"),
    (15, "C2h", "2/m"),
    (24, "D2", "mmm"),
    (46, "C2v", "mmm"),
    (74, "D2h", "mmm"),
    (80, "C4", "4/m"),
    (82, "S4", "4/m"),
    (88, "C4h", "4/m"),
    (98, "D4", "4/mmm"),
    (110, "C4v", "4/mmm"),
    (122, "D2d", "4/mmm"),
    (142, "D4h", "4/mmm"),
    (146, "C3", "-3"),
    (148, "C3i", "-3"),
    (155, "D3", "-3m"),
    (161, "C3v", "-3m"),
    (167, "D3d", "-3m"),
    (173, "C6", "6/m"),
    (174, "C3h", "6/m"),
    (176, "C6h", "6/m"),
    (182, "D6", "6/mmm"),
    (186, "C6v", "6/mmm"),
    (190, "D3h", "6/mmm"),
    (194, "D6h", "6/mmm"),
    (199, "T", "m-3"),
    (206, "Th", "m-3"),
    (214, "O", "m-3m"),
    (220, "Td", "m-3m"),
    (230, "Oh", "m-3m"),
];

/// The place of a number in [`CLASSES`], and the first number of its point group.
fn class(number: u32) -> (u32, &'static str, &'static str) {
    let mut first = 1;
    for (last, schoenflies, laue) in CLASSES {
        if number <= last {
            return (first, schoenflies, laue);
        }
        first = last + 1;
    }
    (first, "Oh", "m-3m")
}

impl SpaceGroup {
    /// The crystal system.
    pub fn crystal_system(&self) -> CrystalSystem {
        CrystalSystem::of_space_group(self.number).unwrap_or(CrystalSystem::Triclinic)
    }

    /// The Laue class: the point group with an inversion added, such as `4/mmm`.
    pub fn laue_class(&self) -> &'static str {
        class(self.number).2
    }

    /// The Schoenflies symbol, its superscript after `^`.
    ///
    /// The superscripts count the groups of a point group in the order of their numbers.
    ///
    /// ```
    /// use ga_design::crystallography::SpaceGroup;
    ///
    /// assert_eq!(SpaceGroup::standard(62).map(|group| group.schoenflies()).as_deref(), Some("D2h^16"));
    /// ```
    pub fn schoenflies(&self) -> String {
        let (first, name, _) = class(self.number);
        format!("{name}^{}", self.number + 1 - first)
    }

    /// The centring letter of the cell: P, A, B, C, I, F, or R for both settings of a
    /// rhombohedral lattice.
    pub fn centring(&self) -> char {
        self.symbol.chars().next().unwrap_or('P')
    }

    /// The full Hermann–Mauguin symbol, axes and planes of every direction: `P 21/n 21/m 21/a`
    /// for `P n m a`.
    pub fn full_symbol(&self) -> &'static str {
        let written = self.also.iter().copied();
        let mut full = written.filter(|name| name.contains('/') && name.contains(' '));
        full.next().unwrap_or(self.symbol)
    }

    /// The short Hermann–Mauguin symbol: `P 21/c` for `P 1 21/c 1`. Monoclinic settings other
    /// than unique axis b keep the ones that tell the axis.
    pub fn short_symbol(&self) -> String {
        match self.symbol.split(' ').collect::<Vec<_>>().as_slice() {
            [letter, "1", element, "1"] if self.crystal_system() == CrystalSystem::Monoclinic => {
                format!("{letter} {element}")
            }
            _ => self.symbol.to_owned(),
        }
    }
}
