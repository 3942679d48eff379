//! What a recognised setting makes of cells, and how its group is grown in one.

use super::super::generators::{Generation, GenerationError, SpaceGroupGenerators};
use super::super::{Cell, CellError, hall};
use super::{ChangeOfBasis, Recognition, SpaceGroup};
use ga_cga::Vector3;

impl Recognition {
    /// What the operations of a Hall symbol are, in whatever setting: the table need not have it.
    ///
    /// `None` when the text is no Hall symbol, and as for [`SpaceGroup::recognise`].
    ///
    /// ```
    /// use ga_design::crystallography::Recognition;
    ///
    /// let found = Recognition::of_hall("-P 2ybc (x+1/4,y,z)");
    /// assert_eq!(found.map(|found| found.number), Some(14));
    /// ```
    pub fn of_hall(symbol: &str) -> Option<Self> {
        // A lattice letter alone, such as `F`, is the beginning of a symbol.
        if !symbol.contains(|c: char| c.is_ascii_digit()) {
            return None;
        }
        SpaceGroup::recognise(&hall::operations(symbol.trim()).ok()?)
    }

    /// The cell of this setting in a lattice that is given by its standard cell.
    ///
    /// # Errors
    /// [`CellError`] when the edges of the setting are too long or too oblique.
    pub fn cell(&self, standard: &Cell) -> Result<Cell, CellError> {
        carried(standard, &self.from_standard)
    }

    /// A cell of this setting with the rounding of its lengths and angles taken out, as far as the
    /// standard cell of the same lattice must keep constraints.
    ///
    /// # Errors
    /// [`GenerationError::Constraint`] names the constraint that the standard cell violates.
    pub fn idealized(&self, cell: &Cell) -> Result<Cell, GenerationError> {
        let number = self.number;
        let group = SpaceGroup::standard(number).ok_or(GenerationError::Basis { number })?;
        let standard = carried(cell, &self.from_standard.inverse())?;
        let shape = group.cell_shape();
        shape.check(&standard)?;
        Ok(self.cell(&shape.idealized(&standard)?)?)
    }

    /// The group grown from its roots in a cell of this setting, with the constraints kept as
    /// [`idealized`](Recognition::idealized) keeps them.
    ///
    /// # Errors
    /// As for [`idealized`](Recognition::idealized) and [`SpaceGroupGenerators::generate_in`].
    pub fn generate(&self, cell: &Cell) -> Result<Generation, GenerationError> {
        let number = self.number;
        let group = SpaceGroupGenerators::of(number).ok_or(GenerationError::Basis { number })?;
        group.generate_in(self.idealized(cell)?, &self.from_standard)
    }
}

/// The cell whose edges are the columns of the change in terms of those of the old one.
fn carried(cell: &Cell, change: &ChangeOfBasis) -> Result<Cell, CellError> {
    let old = cell.edge_vectors().map(Vector3::from);
    let rows = change.linear();
    let edges = [0, 1, 2].map(|column| {
        let terms = old.iter().zip(rows);
        terms.fold(Vector3::default(), |sum, (edge, row)| {
            let part = row[column];
            sum + *edge * (*part.numer() as f64 / *part.denom() as f64)
        })
    });
    let [a, b, c] = edges;
    let angle = |one: Vector3, other: Vector3| {
        let cosine = one.scalar_product(other) / (one.norm() * other.norm());
        cosine.clamp(-1.0, 1.0).acos().to_degrees()
    };
    Cell::new(
        edges.map(|edge| edge.norm()),
        [angle(b, c), angle(c, a), angle(a, b)],
    )
}
