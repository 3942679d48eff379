//! How the generators of a group are placed in the cell of one of its settings.

use ga_cga::Vector3;
use num_rational::Ratio;

use super::super::lattice::{Axis, CellShape, ConstraintError, CrystalSystem};
use super::super::{
    Cell, CellError, ChangeOfBasis, Isometry, NotOfLattice, Operation, Roots, SpaceGroup, close,
};
use super::expression::along;
use super::root_direction::roots_along;
use super::{Generation, GeometricSymbol, GeometricSymbolError, SpaceGroupGenerators};

/// The largest deviation of a root's cosine from that of its angle π/p or π/q.
const ROOT_TOLERANCE: f64 = 1e-9;

/// Why a space group cannot be generated in a cell.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum GenerationError {
    /// The cell does not have the shape of the system.
    #[error(transparent)]
    Constraint(#[from] ConstraintError),
    /// The cell, its constraints kept exactly, is none.
    #[error(transparent)]
    Cell(#[from] CellError),
    /// The roots, along the lattice, are not at the angles of p and q.
    #[error("the roots of space group {number} are not at the angles of their symbol in this cell")]
    Angle {
        /// The number of the group.
        number: u32,
    },
    /// A product of generators is no operation of the lattice.
    #[error(transparent)]
    Lattice(NotOfLattice),
    /// The products go on without end.
    #[error("the generators make more operations modulo the lattice than any point group has")]
    Endless,
    /// The setting is not described by the tables.
    #[error("the tables have no generators for the setting `{hall}`")]
    Setting {
        /// The Hall symbol of the setting.
        hall: &'static str,
    },
    /// The group has no such cell.
    #[error("the change of basis leads to no cell of space group {number}")]
    Basis {
        /// The number of the group.
        number: u32,
    },
}

impl SpaceGroup {
    /// The constraints on the cell in this setting.
    ///
    /// ```
    /// use ga_design::crystallography::{CellShape, SpaceGroup};
    ///
    /// let settings = SpaceGroup::from_symbol("R -3 c:R")?;
    /// assert_eq!(settings[0].cell_shape(), CellShape::Rhombohedral);
    /// # Ok::<(), ga_design::crystallography::UnknownSymbol>(())
    /// ```
    pub fn cell_shape(&self) -> CellShape {
        match self.crystal_system() {
            CrystalSystem::Triclinic => CellShape::Triclinic,
            CrystalSystem::Monoclinic => CellShape::Monoclinic(self.unique_axis()),
            CrystalSystem::Orthorhombic => CellShape::Orthorhombic,
            CrystalSystem::Tetragonal => CellShape::Tetragonal,
            CrystalSystem::Trigonal if self.choice == Some('R') => CellShape::Rhombohedral,
            CrystalSystem::Trigonal | CrystalSystem::Hexagonal => CellShape::Hexagonal,
            CrystalSystem::Cubic => CellShape::Cubic,
        }
    }

    /// The edge that the twofold axis of the standard setting, along **b**, has become.
    fn unique_axis(&self) -> Axis {
        let image = self.from_standard().map(|change| change.inverse().linear());
        let along = |at: usize| image.is_some_and(|rows| *rows[at][1].numer() != 0);
        match (along(0), along(2)) {
            (true, _) => Axis::A,
            (_, true) => Axis::C,
            _ => Axis::B,
        }
    }

    /// The geometric symbol, that of the number whatever the setting.
    pub fn geometric(&self) -> Option<GeometricSymbol> {
        self.generators().map(|group| group.symbol)
    }

    /// The standard setting of the group with a geometric symbol such as `P b(4)_1 b(2)`;
    /// [`SpaceGroupGenerators::from_symbol`] says how it may be spelled.
    ///
    /// ```
    /// use ga_design::crystallography::SpaceGroup;
    ///
    /// let diamond = SpaceGroup::from_geometric("F_d 43")?;
    /// assert_eq!(diamond.symbol, "F d -3 m");
    /// # Ok::<(), ga_design::crystallography::GeometricSymbolError>(())
    /// ```
    ///
    /// # Errors
    /// [`GeometricSymbolError`]: no such symbol, with the nearest known ones.
    pub fn from_geometric(symbol: &str) -> Result<&'static Self, GeometricSymbolError> {
        SpaceGroupGenerators::from_symbol(symbol).map(|group| group.standard)
    }

    /// The roots and generators of the group, as they are in the standard setting.
    pub fn generators(&self) -> Option<&'static SpaceGroupGenerators> {
        SpaceGroupGenerators::of(self.number)
    }

    /// The group grown from its roots in a cell, as versors and as operations of this setting.
    ///
    /// ```
    /// use ga_design::crystallography::{Cell, SpaceGroup};
    ///
    /// let quartz = SpaceGroup::standard(154).unwrap();
    /// let cell = Cell::new([4.916, 4.916, 5.4054], [90.0, 90.0, 120.0])?;
    /// let group = quartz.generate(&cell)?;
    /// assert_eq!(group.representatives().len(), 6);
    /// assert_eq!(group.operations()[1].determinant(), 1);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`GenerationError::Constraint`] names the constraint that the cell violates; rounding
    /// within the tolerance of [`CellShape::check`] is taken out first.
    pub fn generate(&self, cell: &Cell) -> Result<Generation, GenerationError> {
        let shape = self.cell_shape();
        shape.check(cell)?;
        self.grow(shape.idealized(cell)?)
    }

    /// The group grown in some cell of its shape, where only the operations matter.
    ///
    /// # Errors
    /// None for the settings of the table.
    pub fn generate_operations(&self) -> Result<Vec<Operation>, GenerationError> {
        let cell = self.cell_shape().example().cell()?;
        Ok(self.grow(cell)?.operations())
    }

    /// The versors of all operations of the group in a cell, modulo its edges: those of
    /// [`generate`](SpaceGroup::generate).
    ///
    /// # Errors
    /// As for [`generate`](SpaceGroup::generate).
    pub fn versors(&self, cell: &Cell) -> Result<Vec<Isometry>, GenerationError> {
        Ok(self.generate(cell)?.versors())
    }

    fn grow(&self, cell: Cell) -> Result<Generation, GenerationError> {
        match (self.generators(), self.from_standard()) {
            (Some(group), Some(change)) => group.generate_in(cell, &change),
            _ => Err(GenerationError::Setting { hall: self.hall }),
        }
    }
}

impl SpaceGroupGenerators {
    /// The group grown from its roots in a cell of any setting, to which a change of basis leads from
    /// the standard one: of settings that are in no table too.
    ///
    /// # Errors
    /// [`GenerationError::Basis`] when the group has no such setting; others when the cell does not have
    /// its shape there. The constraints are not looked at one by one, and no rounding is taken out.
    pub fn generate_in(
        &self,
        cell: Cell,
        from_standard: &ChangeOfBasis,
    ) -> Result<Generation, GenerationError> {
        let (group, change) = (self, from_standard);
        let to_setting = change.inverse();
        let translations = translations(group, &to_setting).ok_or(GenerationError::Basis {
            number: self.number,
        })?;
        let (edges, origin) = standard_frame(&cell, &to_setting);
        let roots = group.roots_in(&edges).ok_or(GenerationError::Angle {
            number: self.number,
        })?;
        let frame = Isometry::translation(origin + along(group.origin, &edges));
        let generators = group
            .generators
            .iter()
            .map(|generator| Some(generator.isometry(&roots, &edges)?.moved_by(&frame)))
            .collect::<Option<Vec<Isometry>>>()
            .ok_or(GenerationError::Angle {
                number: self.number,
            })?;
        Generation::close(cell, generators, translations)
    }

    /// The roots along a lattice with these edges of the standard setting, if they are at the
    /// angles π/p, π/q and π/2 there; those that no generator uses are zero.
    pub fn roots_in(&self, edges: &[Vector3; 3]) -> Option<[Vector3; 3]> {
        let placed = roots_along(self.roots, edges)?;
        let abstract_roots: Roots = self.symbol.point.roots().ok()?;
        let wanted = abstract_roots.vectors();
        for (one, other) in [(0, 1), (1, 2), (2, 0)] {
            let found = placed[one].scalar_product(placed[other]);
            let needed = wanted[one].scalar_product(wanted[other]);
            let used = placed[one] != Vector3::default() && placed[other] != Vector3::default();
            if used && (found - needed).abs() > ROOT_TOLERANCE {
                return None;
            }
        }
        Some(placed)
    }
}

/// The edges and the origin of the standard cell, in the space in which the cell of the setting
/// is given; the map leads from standard coordinates to those of the setting.
fn standard_frame(cell: &Cell, to_setting: &ChangeOfBasis) -> ([Vector3; 3], Vector3) {
    let edges = cell.edge_vectors().map(Vector3::from);
    let ratio = |value: Ratio<i64>| *value.numer() as f64 / *value.denom() as f64;
    let sum = |column: [Ratio<i64>; 3]| {
        let terms = edges.iter().zip(column);
        terms.fold(Vector3::default(), |sum, (edge, part)| {
            sum + *edge * ratio(part)
        })
    };
    let rows = to_setting.linear();
    let standard = [0, 1, 2].map(|axis| sum(rows.map(|row| row[axis])));
    (standard, sum(to_setting.shift()))
}

/// The lattice points of one cell of the setting: the images of the standard lattice, modulo the
/// edges.
fn translations(
    group: &SpaceGroupGenerators,
    to_setting: &ChangeOfBasis,
) -> Option<Vec<Operation>> {
    let from_standard = to_setting.inverse();
    let mut images = from_standard.old_lattice()?.to_vec();
    for translation in group.centring.translations() {
        images.push(from_standard.operation(&translation)?);
    }
    close(&images).ok()
}
