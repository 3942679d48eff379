//! Which seven crystal systems there are, and how they are named.

use std::fmt;
use std::str::FromStr;

/// A crystal system: point groups that are classed together by their rotations.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum CrystalSystem {
    /// No rotation; an inversion at most.
    Triclinic,
    /// One twofold axis or mirror.
    Monoclinic,
    /// Three twofold axes or mirrors at right angles.
    Orthorhombic,
    /// One fourfold axis.
    Tetragonal,
    /// One threefold axis.
    Trigonal,
    /// One sixfold axis.
    Hexagonal,
    /// Four threefold axes.
    Cubic,
}

/// A word that names no crystal system.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "unknown crystal system `{found}`; one of triclinic, monoclinic, orthorhombic, tetragonal, \
     trigonal, hexagonal, cubic"
)]
pub struct UnknownSystem {
    /// The word as given, shortened when very long.
    pub found: String,
}

impl CrystalSystem {
    /// The seven systems, from the least symmetric.
    pub const ALL: [Self; 7] = [
        Self::Triclinic,
        Self::Monoclinic,
        Self::Orthorhombic,
        Self::Tetragonal,
        Self::Trigonal,
        Self::Hexagonal,
        Self::Cubic,
    ];

    /// The system of a space group by its number in *International Tables*, 1 to 230.
    ///
    /// ```
    /// use ga_design::crystallography::CrystalSystem;
    ///
    /// assert_eq!(CrystalSystem::of_space_group(227), Some(CrystalSystem::Cubic));
    /// assert_eq!(CrystalSystem::of_space_group(231), None);
    /// ```
    pub fn of_space_group(number: u32) -> Option<Self> {
        Some(match number {
            1..=2 => Self::Triclinic,
            3..=15 => Self::Monoclinic,
            16..=74 => Self::Orthorhombic,
            75..=142 => Self::Tetragonal,
            143..=167 => Self::Trigonal,
            168..=194 => Self::Hexagonal,
            195..=230 => Self::Cubic,
            _ => return None,
        })
    }

    /// The name in small letters.
    pub fn name(self) -> &'static str {
        match self {
            Self::Triclinic => "triclinic",
            Self::Monoclinic => "monoclinic",
            Self::Orthorhombic => "orthorhombic",
            Self::Tetragonal => "tetragonal",
            Self::Trigonal => "trigonal",
            Self::Hexagonal => "hexagonal",
            Self::Cubic => "cubic",
        }
    }
}

impl fmt::Display for CrystalSystem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for CrystalSystem {
    type Err = UnknownSystem;

    fn from_str(text: &str) -> Result<Self, UnknownSystem> {
        let wanted = text.trim().to_lowercase();
        Self::ALL
            .into_iter()
            .find(|system| system.name() == wanted)
            .ok_or_else(|| UnknownSystem {
                found: text.chars().take(40).collect(),
            })
    }
}
