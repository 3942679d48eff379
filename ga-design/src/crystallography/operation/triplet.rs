//! Which coordinate triplets are symmetry operations, and what is said of the others.

use std::str::FromStr;

use num_rational::Ratio;

use super::expression::affine;
use super::{DENOMINATOR, LARGEST_ENTRY, Operation};

/// Why a text is no symmetry operation. Columns count characters from 1.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum OperationError {
    /// A character that cannot stand there.
    #[error("unexpected `{found}` at column {column}; write three sums such as `-x+1/2,y,z+1/2`")]
    Unexpected {
        /// The character.
        found: char,
        /// Its column.
        column: usize,
    },
    /// A sum breaks off.
    #[error("the operation ends at column {column} where a term such as `x` or `1/2` should stand")]
    EndsEarly {
        /// The column after the last character.
        column: usize,
    },
    /// One or two sums instead of three.
    #[error("{found} of 3 coordinates by column {column}; write three sums parted by commas")]
    TooFew {
        /// How many there are.
        found: usize,
        /// The column after the last character.
        column: usize,
    },
    /// More than three sums.
    #[error("a fourth coordinate at column {column}; write three sums parted by commas")]
    TooMany {
        /// The column of the third comma.
        column: usize,
    },
    /// `/0`.
    #[error("division by zero at column {column}")]
    DivisionByZero {
        /// The column of the divisor.
        column: usize,
    },
    /// A number beyond anything that a crystal uses.
    #[error("the number at column {column} is too large")]
    TooLarge {
        /// The column of the number.
        column: usize,
    },
    /// More text than an operation can have.
    #[error("longer than {limit} characters")]
    TooLong {
        /// The most characters accepted.
        limit: usize,
    },
    /// A decimal that is no simple fraction.
    #[error("the decimal at column {column} is no multiple of 1/24; write a fraction such as 1/3")]
    NotRational {
        /// The column of the decimal.
        column: usize,
    },
    /// A factor of a coordinate that is no small whole number.
    #[error("the coordinate at column {column} has a factor that is not a small whole number")]
    NotWhole {
        /// The column of the sum.
        column: usize,
    },
    /// A matrix that squeezes or stretches space.
    #[error("the determinant is {determinant}, but a symmetry keeps volume: it must be 1 or -1")]
    NotInvertible {
        /// The determinant found.
        determinant: i32,
    },
}

/// Reads a coordinate triplet as files spell it: either order of fraction and variable, either
/// case, blanks and quotation marks anywhere, `.5` and `0.3333` for fractions.
impl FromStr for Operation {
    type Err = OperationError;

    fn from_str(text: &str) -> Result<Self, OperationError> {
        let map = affine(text)?;
        let mut rotation = [[0; 3]; 3];
        let mut translation = [0; 3];
        for place in 0..3 {
            let column = map.columns[place];
            for (entry, factor) in rotation[place].iter_mut().zip(map.linear[place]) {
                *entry = whole(factor)
                    .filter(|value| value.abs() <= LARGEST_ENTRY)
                    .ok_or(OperationError::NotWhole { column })?;
            }
            translation[place] =
                units(map.shift[place]).ok_or(OperationError::NotRational { column })?;
        }
        Operation::from_units(rotation, translation).ok_or_else(|| OperationError::NotInvertible {
            determinant: determinant(&rotation),
        })
    }
}

fn whole(value: Ratio<i64>) -> Option<i32> {
    value
        .is_integer()
        .then(|| i32::try_from(*value.numer()).ok())
        .flatten()
}

/// A translation in units of one over [`DENOMINATOR`], reduced modulo the lattice.
pub(in crate::crystallography) fn units(value: Ratio<i64>) -> Option<i32> {
    let scale = i64::from(DENOMINATOR);
    if scale % value.denom() != 0 {
        return None;
    }
    let numerator = value.numer().rem_euclid(*value.denom()) * (scale / value.denom());
    i32::try_from(numerator).ok()
}

/// Of entries at most [`LARGEST_ENTRY`], so that nothing overflows.
fn determinant(w: &[[i32; 3]; 3]) -> i32 {
    let [[a, b, c], [d, e, f], [g, h, i]] = *w;
    a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)
}
