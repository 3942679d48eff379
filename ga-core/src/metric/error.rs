//! What can be wrong with a description of a metric.

use alloc::string::String;
use core::fmt;

/// Why names and a matrix do not make a metric. Indices count from zero.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum MetricError {
    /// More basis vectors than [`Metric::MAX_DIMENSION`](crate::Metric::MAX_DIMENSION).
    TooManyDimensions {
        /// The number of basis vectors asked for.
        dimension: usize,
    },
    /// A basis vector without a name.
    EmptyName {
        /// Its position.
        index: usize,
    },
    /// Two basis vectors of one name.
    DuplicateName {
        /// The name.
        name: String,
        /// Where it stands first.
        first: usize,
        /// Where it stands again.
        second: usize,
    },
    /// A matrix with another number of rows than there are names.
    RowCount {
        /// The rows given.
        rows: usize,
        /// The rows needed.
        dimension: usize,
    },
    /// A row with another number of entries than there are names.
    ColumnCount {
        /// The row.
        row: usize,
        /// The entries given.
        columns: usize,
        /// The entries needed.
        dimension: usize,
    },
    /// A fraction with denominator zero.
    ZeroDenominator {
        /// Its row.
        row: usize,
        /// Its column.
        column: usize,
    },
    /// An entry that differs from its mirror image.
    NotSymmetric {
        /// Its row, greater than the column.
        row: usize,
        /// Its column.
        column: usize,
    },
    /// The signature or the determinant needs larger integers than 128 bits.
    Overflow,
}

impl fmt::Display for MetricError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            MetricError::TooManyDimensions { dimension } => write!(
                f,
                "{dimension} basis vectors are more than the {} supported",
                crate::Metric::MAX_DIMENSION
            ),
            MetricError::EmptyName { index } => write!(f, "basis vector {index} has no name"),
            MetricError::DuplicateName {
                name,
                first,
                second,
            } => write!(
                f,
                "basis vectors {first} and {second} are both named `{name}`"
            ),
            MetricError::RowCount { rows, dimension } => {
                write!(
                    f,
                    "the matrix has {rows} rows for {dimension} basis vectors"
                )
            }
            MetricError::ColumnCount {
                row,
                columns,
                dimension,
            } => write!(
                f,
                "row {row} of the matrix has {columns} entries for {dimension} basis vectors"
            ),
            MetricError::ZeroDenominator { row, column } => {
                write!(f, "the entry at ({row}, {column}) has denominator zero")
            }
            MetricError::NotSymmetric { row, column } => write!(
                f,
                "the matrix is not symmetric: the entries at ({row}, {column}) and \
                 ({column}, {row}) differ"
            ),
            MetricError::Overflow => write!(
                f,
                "the entries are too large or too varied for exact 128-bit fractions"
            ),
        }
    }
}

impl core::error::Error for MetricError {}
