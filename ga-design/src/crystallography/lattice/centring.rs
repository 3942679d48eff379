//! Which centrings a cell can have, and where the further lattice points lie.

use std::fmt;

use num_rational::Ratio;

use super::super::Operation;

/// The centring of a cell: which fractions of its edges are lattice vectors too.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Centring {
    /// Primitive: none; also the rhombohedral cell of a rhombohedral lattice.
    P,
    /// The face across **a**: (0, ½, ½).
    A,
    /// The face across **b**: (½, 0, ½).
    B,
    /// The face across **c**: (½, ½, 0).
    C,
    /// The body: (½, ½, ½).
    I,
    /// All faces.
    F,
    /// A rhombohedral lattice on hexagonal axes, obverse: (⅔, ⅓, ⅓) and (⅓, ⅔, ⅔).
    R,
}

impl Centring {
    /// All seven.
    pub const ALL: [Self; 7] = [
        Self::P,
        Self::A,
        Self::B,
        Self::C,
        Self::I,
        Self::F,
        Self::R,
    ];

    /// The centring of a letter.
    pub fn from_letter(letter: char) -> Option<Self> {
        Self::ALL
            .into_iter()
            .find(|centring| centring.letter() == letter)
    }

    /// The letter of International symbols.
    pub fn letter(self) -> char {
        match self {
            Self::P => 'P',
            Self::A => 'A',
            Self::B => 'B',
            Self::C => 'C',
            Self::I => 'I',
            Self::F => 'F',
            Self::R => 'R',
        }
    }

    /// The lattice points of one cell in fractions of its edges, the origin first: as many as
    /// the cell has primitive cells in it.
    ///
    /// ```
    /// use ga_design::crystallography::Centring;
    ///
    /// assert_eq!(Centring::F.points().len(), 4);
    /// ```
    pub fn points(self) -> Vec<[Ratio<i32>; 3]> {
        let sixths: &[[i32; 3]] = match self {
            Self::P => &[],
            Self::A => &[[0, 3, 3]],
            Self::B => &[[3, 0, 3]],
            Self::C => &[[3, 3, 0]],
            Self::I => &[[3, 3, 3]],
            Self::F => &[[0, 3, 3], [3, 0, 3], [3, 3, 0]],
            Self::R => &[[4, 2, 2], [2, 4, 4]],
        };
        std::iter::once(&[0, 0, 0])
            .chain(sixths)
            .map(|point| point.map(|sixth| Ratio::new(sixth, 6)))
            .collect()
    }

    /// The same points as operations, the identity first.
    pub fn translations(self) -> Vec<Operation> {
        let identity = Operation::IDENTITY.rotation();
        self.points()
            .into_iter()
            .filter_map(|point| Operation::new(identity, point))
            .collect()
    }
}

impl fmt::Display for Centring {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.letter())
    }
}
