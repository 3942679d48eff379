//! A metric is a list of named basis vectors and their inner products.

mod diagonalise;
mod error;
mod spelling;

use alloc::format;
use alloc::string::String;
use alloc::vec;
use alloc::vec::Vec;

pub use error::MetricError;

use crate::{Blade, Rational};

/// Named basis vectors together with the symmetric matrix of their inner products (the Gram
/// matrix), of any signature, degenerate or not, diagonal or not.
///
/// Signature and determinant are found once, exactly, when the metric is made.
///
/// ```
/// use ga_core::{Blade, Metric, Rational};
///
/// let one = Rational::from_integer(1);
/// let zero = Rational::from_integer(0);
/// let gram = vec![
///     vec![one, zero, zero],
///     vec![zero, zero, -one],
///     vec![zero, -one, zero],
/// ];
/// let metric = Metric::new(["e1", "no", "ni"], gram)?;
/// assert_eq!(metric.signature(), (2, 1, 0));
/// assert_eq!(metric.blade_name(Blade::new(0b101)), "e1ni");
/// # Ok::<(), ga_core::MetricError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Metric {
    names: Vec<String>,
    /// Row after row.
    gram: Vec<Rational>,
    signature: (usize, usize, usize),
    determinant: Rational,
    diagonal: bool,
    /// Whether the names of blades stay distinct when written without a wedge between.
    concise: bool,
}

impl Metric {
    /// The largest number of basis vectors.
    pub const MAX_DIMENSION: usize = 16;

    /// The orthonormal metric with `positive` vectors of square 1, then `negative` of square
    /// −1, then `null` of square 0, named e1, e2, …
    ///
    /// # Errors
    /// [`MetricError::TooManyDimensions`] beyond [`MAX_DIMENSION`](Metric::MAX_DIMENSION).
    pub fn from_signature(
        positive: usize,
        negative: usize,
        null: usize,
    ) -> Result<Metric, MetricError> {
        let squares = [(positive, 1), (negative, -1), (null, 0)];
        let dimension = positive.saturating_add(negative).saturating_add(null);
        check_dimension(dimension)?;
        let names = (1..=dimension).map(|number| format!("e{number}"));
        let mut gram = vec![vec![Rational::ZERO; dimension]; dimension];
        let diagonal = squares
            .into_iter()
            .flat_map(|(count, square)| core::iter::repeat_n(square, count));
        for (index, (row, square)) in gram.iter_mut().zip(diagonal).enumerate() {
            row[index] = Rational::from_integer(square);
        }
        Metric::new(names, gram)
    }

    /// The metric with these basis names and these inner products, `gram[i][j]` = eᵢ·eⱼ.
    ///
    /// # Errors
    /// Every kind of [`MetricError`]; the first one met in the order of its variants.
    pub fn new<Name: Into<String>>(
        names: impl IntoIterator<Item = Name>,
        gram: Vec<Vec<Rational>>,
    ) -> Result<Metric, MetricError> {
        let names: Vec<String> = names.into_iter().map(Into::into).collect();
        let dimension = names.len();
        check_dimension(dimension)?;
        check_names(&names)?;
        check_square(dimension, &gram)?;
        let gram = check_fractions(gram)?;
        check_symmetric(&gram)?;
        let pivots = diagonalise::pivots(gram.clone()).ok_or(MetricError::Overflow)?;
        let diagonal = gram.iter().enumerate().all(|(i, row)| {
            let mut others = row.iter().enumerate().filter(|&(j, _)| j != i);
            others.all(|(_, entry)| *entry == Rational::ZERO)
        });
        Ok(Metric {
            signature: diagonalise::signature(&pivots),
            determinant: diagonalise::determinant(&pivots).ok_or(MetricError::Overflow)?,
            diagonal,
            concise: spelling::is_unambiguous(&names),
            gram: gram.into_iter().flatten().collect(),
            names,
        })
    }

    /// The number of basis vectors.
    pub fn dimension(&self) -> usize {
        self.names.len()
    }

    /// The names of the basis vectors, in order.
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// The inner product of basis vectors `i` and `j`, counted from zero; zero for an index
    /// beyond the dimension, since no such vector meets any other.
    pub fn gram(&self, i: usize, j: usize) -> Rational {
        let dimension = self.dimension();
        if i < dimension && j < dimension {
            self.gram[i * dimension + j]
        } else {
            Rational::ZERO
        }
    }

    /// Whether different basis vectors are orthogonal.
    pub fn is_diagonal(&self) -> bool {
        self.diagonal
    }

    /// How many vectors of an orthogonal basis have positive, negative and zero square
    /// (Sylvester's law of inertia: the same in every orthogonal basis).
    pub fn signature(&self) -> (usize, usize, usize) {
        self.signature
    }

    /// The determinant of the Gram matrix; I² is this times (−1)^{n(n−1)/2}.
    pub fn determinant(&self) -> Rational {
        self.determinant
    }

    /// Whether some vector is orthogonal to all: then I has no inverse and no dual exists.
    pub fn is_degenerate(&self) -> bool {
        self.signature.2 > 0
    }

    /// Whether every basis vector of `blade` belongs to this metric.
    pub fn contains(&self, blade: Blade) -> bool {
        blade.mask() & !Blade::pseudoscalar(self.dimension()).mask() == 0
    }

    /// All basis blades in order of grade, then mask.
    pub fn blades(&self) -> Vec<Blade> {
        let mut blades: Vec<Blade> = (0..1 << self.dimension()).map(Blade::new).collect();
        blades.sort_unstable();
        blades
    }

    /// The name of a basis blade: `1` for the scalar, otherwise the names of its vectors, a
    /// shared prefix before single digits written once (`e12ni`). In a metric where that could
    /// be misread (`e12` of e1 … e12) the names are joined by wedges instead (`e1^e10`).
    ///
    /// Basis vectors beyond the dimension are left out.
    pub fn blade_name(&self, blade: Blade) -> String {
        spelling::blade_name(&self.names, blade, self.concise)
    }
}

fn check_dimension(dimension: usize) -> Result<(), MetricError> {
    if dimension > Metric::MAX_DIMENSION {
        return Err(MetricError::TooManyDimensions { dimension });
    }
    Ok(())
}

fn check_names(names: &[String]) -> Result<(), MetricError> {
    for (second, name) in names.iter().enumerate() {
        if name.is_empty() {
            return Err(MetricError::EmptyName { index: second });
        }
        if let Some(first) = names[..second].iter().position(|other| other == name) {
            let name = name.clone();
            return Err(MetricError::DuplicateName {
                name,
                first,
                second,
            });
        }
    }
    Ok(())
}

fn check_square(dimension: usize, gram: &[Vec<Rational>]) -> Result<(), MetricError> {
    if gram.len() != dimension {
        let rows = gram.len();
        return Err(MetricError::RowCount { rows, dimension });
    }
    for (row, entries) in gram.iter().enumerate() {
        if entries.len() != dimension {
            let columns = entries.len();
            return Err(MetricError::ColumnCount {
                row,
                columns,
                dimension,
            });
        }
    }
    Ok(())
}

/// Fractions made without normalisation (`Ratio::new_raw`) are brought to lowest terms, since
/// all later arithmetic relies on it.
fn check_fractions(mut gram: Vec<Vec<Rational>>) -> Result<Vec<Vec<Rational>>, MetricError> {
    for (row, entries) in gram.iter_mut().enumerate() {
        for (column, entry) in entries.iter_mut().enumerate() {
            let (numerator, denominator) = (*entry.numer(), *entry.denom());
            if denominator == 0 {
                return Err(MetricError::ZeroDenominator { row, column });
            }
            if numerator == i128::MIN || denominator == i128::MIN {
                return Err(MetricError::Overflow);
            }
            *entry = Rational::new(numerator, denominator);
        }
    }
    Ok(gram)
}

fn check_symmetric(gram: &[Vec<Rational>]) -> Result<(), MetricError> {
    for (row, entries) in gram.iter().enumerate() {
        for (column, entry) in entries.iter().enumerate().take(row) {
            if *entry != gram[column][row] {
                return Err(MetricError::NotSymmetric { row, column });
            }
        }
    }
    Ok(())
}
