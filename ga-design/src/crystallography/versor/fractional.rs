//! How an isometry in space and an operation in fractional coordinates become each other.

use ga_cga::{DirectionVector, Vector3};

use super::super::operation::DENOMINATOR;
use super::super::{Cell, Operation, Placement, PlacementError, close};
use super::Isometry;

/// The largest distance of a matrix entry from an integer, and of a translation from an exact
/// fraction of an edge, that is taken for rounding.
const TOLERANCE: f64 = 1e-6;

/// Why an isometry is no operation of a lattice.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum NotOfLattice {
    /// Lattice vectors do not go to lattice vectors.
    #[error(
        "the isometry does not carry the lattice to itself: an edge goes to a vector that is off \
         by {residual:.2e} edges from one of the lattice"
    )]
    Matrix {
        /// The largest distance of a matrix entry from an integer.
        residual: f64,
    },
    /// The translation is no fraction that an operation can have.
    #[error(
        "the translation of the isometry is off by {residual:.2e} edges from a multiple of \
         1/{DENOMINATOR} of the edges"
    )]
    Translation {
        /// The largest distance of a component from such a multiple.
        residual: f64,
    },
}

impl Isometry {
    /// The isometry of an operation in a cell that has its symmetry.
    ///
    /// A whole group in a measured cell is better placed by [`Placement::of_group`], which takes
    /// the rounding out of the cell once for all operations.
    ///
    /// ```
    /// use ga_design::crystallography::{Cell, Isometry, Operation};
    ///
    /// let cell = Cell::new([4.0, 4.0, 6.0], [90.0, 90.0, 120.0])?;
    /// let screw: Operation = "-y,x-y,z+1/3".parse()?;
    /// let versor = Isometry::of_operation(&screw, &cell)?;
    /// assert_eq!(versor.operation(&cell), Ok(screw));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`PlacementError::Misfit`] when the cell does not have the symmetry.
    pub fn of_operation(operation: &Operation, cell: &Cell) -> Result<Self, PlacementError> {
        // An operation of endless powers fits no cell; its own misfit is then what is reported.
        let group = close(&[*operation]).unwrap_or_else(|_| vec![*operation]);
        let (_, lattice) = Placement::of_group(&group, cell)?;
        Ok(Self::from(&lattice.placement(operation)))
    }

    /// The operation in fractional coordinates, modulo the lattice, that this isometry is in a
    /// cell: the other way round.
    ///
    /// # Errors
    /// [`NotOfLattice`] when it does not carry the lattice to itself or its translation is no
    /// exact fraction.
    pub fn operation(&self, cell: &Cell) -> Result<Operation, NotOfLattice> {
        let images = cell.edge_vectors().map(|edge| {
            let direction = DirectionVector::along(Vector3::from(edge));
            cell.fractional(self.apply(direction).vector().to_array())
        });
        let mut rotation = [[0; 3]; 3];
        let mut residual: f64 = 0.0;
        for (column, image) in images.iter().enumerate() {
            for (row, value) in rotation.iter_mut().zip(image) {
                residual = worse(residual, value - value.round());
                row[column] = value.round() as i32;
            }
        }
        if residual.is_nan() || residual > TOLERANCE {
            return Err(NotOfLattice::Matrix { residual });
        }
        let shift = cell.fractional(self.shift().to_array());
        let units = shift.map(|value| value.rem_euclid(1.0) * f64::from(DENOMINATOR));
        let mut residual = units.iter().fold(0.0, |most, unit| {
            worse(most, (unit - unit.round()) / f64::from(DENOMINATOR))
        });
        // So far away the numbers themselves are rounded to less than a fraction of an edge.
        for value in shift {
            residual = worse(residual, value * f64::EPSILON);
        }
        if residual.is_nan() || residual > TOLERANCE {
            return Err(NotOfLattice::Translation { residual });
        }
        Operation::from_units(rotation, units.map(|unit| unit.round() as i32))
            .ok_or(NotOfLattice::Matrix { residual: 1.0 })
    }
}

/// The larger size of the two, and NaN if one is NaN.
fn worse(most: f64, next: f64) -> f64 {
    if next.is_nan() || most.is_nan() {
        f64::NAN
    } else {
        most.max(next.abs())
    }
}
