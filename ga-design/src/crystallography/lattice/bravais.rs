//! Which fourteen lattices there are, and which of them a cell of a system with a centring spans.

use super::{Centring, CrystalSystem};

/// One of the fourteen Bravais lattices.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum BravaisLattice {
    /// Any cell.
    Triclinic,
    /// A monoclinic cell.
    Monoclinic,
    /// A monoclinic cell with one centred face, or centred.
    MonoclinicCentred,
    /// A box.
    Orthorhombic,
    /// A box with one centred face.
    OrthorhombicBaseCentred,
    /// A centred box.
    OrthorhombicBodyCentred,
    /// A box with all faces centred.
    OrthorhombicFaceCentred,
    /// A box on a square.
    Tetragonal,
    /// A centred box on a square.
    TetragonalBodyCentred,
    /// A prism on a rhomb of 120°.
    Hexagonal,
    /// A cube drawn out along its diagonal.
    Rhombohedral,
    /// A cube.
    Cubic,
    /// A centred cube.
    CubicBodyCentred,
    /// A cube with all faces centred.
    CubicFaceCentred,
}

impl BravaisLattice {
    /// All fourteen.
    pub const ALL: [Self; 14] = [
        Self::Triclinic,
        Self::Monoclinic,
        Self::MonoclinicCentred,
        Self::Orthorhombic,
        Self::OrthorhombicBaseCentred,
        Self::OrthorhombicBodyCentred,
        Self::OrthorhombicFaceCentred,
        Self::Tetragonal,
        Self::TetragonalBodyCentred,
        Self::Hexagonal,
        Self::Rhombohedral,
        Self::Cubic,
        Self::CubicBodyCentred,
        Self::CubicFaceCentred,
    ];

    /// The lattice of a cell of this system with this centring; `None` where the centring takes
    /// the symmetry of the system away.
    ///
    /// Some centrings of a system are another cell of a lattice that has a smaller one: a
    /// tetragonal C is P, F is I; a monoclinic I or F is C.
    ///
    /// ```
    /// use ga_design::crystallography::{BravaisLattice, Centring, CrystalSystem};
    ///
    /// let diamond = BravaisLattice::of(CrystalSystem::Cubic, Centring::F);
    /// assert_eq!(diamond.map(BravaisLattice::pearson), Some("cF"));
    /// assert_eq!(BravaisLattice::of(CrystalSystem::Cubic, Centring::C), None);
    /// ```
    pub fn of(system: CrystalSystem, centring: Centring) -> Option<Self> {
        use Centring::{A, B, C, F, I, P, R};
        Some(match (system, centring) {
            (CrystalSystem::Triclinic, _) => Self::Triclinic,
            (CrystalSystem::Monoclinic, P) => Self::Monoclinic,
            (CrystalSystem::Monoclinic, A | B | C | I | F) => Self::MonoclinicCentred,
            (CrystalSystem::Orthorhombic, P) => Self::Orthorhombic,
            (CrystalSystem::Orthorhombic, A | B | C) => Self::OrthorhombicBaseCentred,
            (CrystalSystem::Orthorhombic, I) => Self::OrthorhombicBodyCentred,
            (CrystalSystem::Orthorhombic, F) => Self::OrthorhombicFaceCentred,
            (CrystalSystem::Tetragonal, P | C) => Self::Tetragonal,
            (CrystalSystem::Tetragonal, I | F) => Self::TetragonalBodyCentred,
            (CrystalSystem::Trigonal | CrystalSystem::Hexagonal, P) => Self::Hexagonal,
            (CrystalSystem::Trigonal, R) => Self::Rhombohedral,
            (CrystalSystem::Cubic, P) => Self::Cubic,
            (CrystalSystem::Cubic, I) => Self::CubicBodyCentred,
            (CrystalSystem::Cubic, F) => Self::CubicFaceCentred,
            _ => return None,
        })
    }

    /// The Pearson symbol: `aP`, `mP`, `mS`, `oP`, `oS`, `oI`, `oF`, `tP`, `tI`, `hP`, `hR`,
    /// `cP`, `cI`, `cF`.
    pub fn pearson(self) -> &'static str {
        match self {
            Self::Triclinic => "aP",
            Self::Monoclinic => "mP",
            Self::MonoclinicCentred => "mS",
            Self::Orthorhombic => "oP",
            Self::OrthorhombicBaseCentred => "oS",
            Self::OrthorhombicBodyCentred => "oI",
            Self::OrthorhombicFaceCentred => "oF",
            Self::Tetragonal => "tP",
            Self::TetragonalBodyCentred => "tI",
            Self::Hexagonal => "hP",
            Self::Rhombohedral => "hR",
            Self::Cubic => "cP",
            Self::CubicBodyCentred => "cI",
            Self::CubicFaceCentred => "cF",
        }
    }

    /// The lattice of a Pearson symbol.
    pub fn from_pearson(symbol: &str) -> Option<Self> {
        Self::ALL
            .into_iter()
            .find(|lattice| lattice.pearson() == symbol)
    }

    /// The order of the point group of the lattice itself.
    pub fn holohedry_order(self) -> usize {
        match self {
            Self::Triclinic => 2,
            Self::Monoclinic | Self::MonoclinicCentred => 4,
            Self::Orthorhombic
            | Self::OrthorhombicBaseCentred
            | Self::OrthorhombicBodyCentred
            | Self::OrthorhombicFaceCentred => 8,
            Self::Tetragonal | Self::TetragonalBodyCentred => 16,
            Self::Hexagonal => 24,
            Self::Rhombohedral => 12,
            Self::Cubic | Self::CubicBodyCentred | Self::CubicFaceCentred => 48,
        }
    }
}
