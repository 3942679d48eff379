//! How the generators of a group are placed in the cell of one of its settings.

use ga_cga::Vector3;
use num_rational::Ratio;

use super::super::lattice::{Axis, CellShape, ConstraintError, CrystalSystem};
use super::super::operation::{Affine, affine};
use super::super::{Cell, CellError, Isometry, NotOfLattice, Operation, Roots, SpaceGroup, close};
use super::direction::roots_along;
use super::expression::along;
use super::{Generation, SpaceGroupGenerators};

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
}

impl SpaceGroup {
    /// The crystal system.
    pub fn system(&self) -> CrystalSystem {
        CrystalSystem::of_space_group(self.number).unwrap_or(CrystalSystem::Triclinic)
    }

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
        match self.system() {
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
        let image = self.change().map(|map| map.linear.map(|row| row[1]));
        let along = |at: usize| image.is_some_and(|image| *image[at].numer() != 0);
        match (along(0), along(2)) {
            (true, _) => Axis::A,
            (_, true) => Axis::C,
            _ => Axis::B,
        }
    }

    /// The map from the coordinates of the standard setting to those of this one.
    fn change(&self) -> Option<Affine> {
        affine(self.change_of_basis).ok()
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
        let missing = GenerationError::Setting { hall: self.hall };
        let (Some(group), Some(change)) = (self.generators(), self.change()) else {
            return Err(missing);
        };
        let translations = translations(group, &change).ok_or(missing)?;
        let (edges, origin) = standard_frame(&cell, &change);
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
}

impl SpaceGroupGenerators {
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
/// is given: new coordinates are `V x + v` of the standard ones.
fn standard_frame(cell: &Cell, change: &Affine) -> ([Vector3; 3], Vector3) {
    let edges = cell.edge_vectors().map(Vector3::from);
    let ratio = |value: Ratio<i64>| *value.numer() as f64 / *value.denom() as f64;
    let sum = |column: [Ratio<i64>; 3]| {
        let terms = edges.iter().zip(column);
        terms.fold(Vector3::default(), |sum, (edge, part)| {
            sum + *edge * ratio(part)
        })
    };
    let standard = [0, 1, 2].map(|axis| sum(change.linear.map(|row| row[axis])));
    (standard, sum(change.shift))
}

/// The lattice points of one cell of the setting: the images of the standard lattice, modulo the
/// edges.
fn translations(group: &SpaceGroupGenerators, change: &Affine) -> Option<Vec<Operation>> {
    let zero = Ratio::from_integer(0_i64);
    let whole = |axis: usize| {
        let mut unit = [zero; 3];
        unit[axis] = Ratio::from_integer(1);
        unit
    };
    let wide = |point: [Ratio<i32>; 3]| {
        point.map(|part| Ratio::new(i64::from(*part.numer()), i64::from(*part.denom())))
    };
    let standard = (0..3)
        .map(whole)
        .chain(group.centring.points().into_iter().map(wide));
    let mut images = Vec::new();
    for vector in standard {
        let mut units = [0; 3];
        for (unit, row) in units.iter_mut().zip(change.linear) {
            let part = row[0] * vector[0] + row[1] * vector[1] + row[2] * vector[2];
            *unit = super::super::operation::units(part)?;
        }
        images.push(Operation::from_units(
            Operation::IDENTITY.rotation(),
            units,
        )?);
    }
    close(&images).ok()
}
