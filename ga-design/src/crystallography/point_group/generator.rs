//! Which products of the roots generate groups, and how they are encoded (Table 3.2).

use std::fmt;

use ga_cga::Vector3;

use super::super::Isometry;

/// A word in the roots: one of three reflections, three rotations and two roto-reflections.
///
/// A word is the geometric product of its letters, so that its last letter acts first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Word {
    /// The reflection **a**.
    A,
    /// The reflection **b**.
    B,
    /// The reflection **c**.
    C,
    /// The rotation **ab** by 2π/p.
    Ab,
    /// The rotation **bc** by 2π/q.
    Bc,
    /// The half turn **ca**.
    Ca,
    /// The roto-reflection **abc**.
    Abc,
    /// The roto-reflection **bac**.
    Bac,
}

impl Word {
    /// All words, in the order of their encoding.
    pub const ALL: [Self; 8] = [
        Self::A,
        Self::B,
        Self::C,
        Self::Ab,
        Self::Bc,
        Self::Ca,
        Self::Abc,
        Self::Bac,
    ];

    /// The type of the encoding: 0 for reflections, 1 for rotations, 2 for roto-reflections.
    pub fn kind(self) -> u8 {
        match self {
            Self::A | Self::B | Self::C => 0,
            Self::Ab | Self::Bc | Self::Ca => 1,
            Self::Abc | Self::Bac => 2,
        }
    }

    /// The index of the encoding in its type: **a**, **b**, **c**; **ab**, **bc**, **ca**;
    /// **abc**, **bac**.
    pub fn index(self) -> u8 {
        match self {
            Self::A | Self::Ab | Self::Abc => 0,
            Self::B | Self::Bc | Self::Bac => 1,
            Self::C | Self::Ca => 2,
        }
    }

    /// The word of an encoding {type, index}.
    pub fn from_encoding(kind: u8, index: u8) -> Option<Self> {
        Self::ALL
            .into_iter()
            .find(|word| (word.kind(), word.index()) == (kind, index))
    }

    /// The letters.
    pub fn letters(self) -> &'static str {
        match self {
            Self::A => "a",
            Self::B => "b",
            Self::C => "c",
            Self::Ab => "ab",
            Self::Bc => "bc",
            Self::Ca => "ca",
            Self::Abc => "abc",
            Self::Bac => "bac",
        }
    }

    /// The word with these letters.
    pub fn from_letters(letters: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|word| word.letters() == letters)
    }

    /// The product of the reflections across the roots **a**, **b**, **c** that are given, through
    /// the origin; `None` if one that the word needs has no direction.
    pub fn isometry(self, roots: &[Vector3; 3]) -> Option<Isometry> {
        let [a, b, c] = roots;
        self.letters()
            .chars()
            .map(|letter| match letter {
                'a' => a,
                'b' => b,
                _ => c,
            })
            .try_fold(Isometry::identity(), |product, root| {
                Some(product.after(&Isometry::reflection(*root)?))
            })
    }
}

impl fmt::Display for Word {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.letters())
    }
}
