//! Why an operation of the run-time algebra has no result.

use core::fmt;

use crate::Blade;

/// Why an operation on dense multivectors has no result.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum DenseError {
    /// More basis vectors than [`Algebra::MAX_DIMENSION`](super::Algebra::MAX_DIMENSION).
    TooManyDimensions {
        /// The dimension of the metric.
        dimension: usize,
    },
    /// An inner product of basis vectors that the coefficient type cannot hold: a fraction in
    /// a ring of integers, or integers beyond 64 bits.
    InnerProduct {
        /// The first basis vector, counted from zero.
        row: usize,
        /// The second basis vector.
        column: usize,
    },
    /// A blade with basis vectors beyond the dimension.
    NoSuchBlade(
        /// The blade.
        Blade,
    ),
    /// Another number of coefficients than the algebra needs.
    CoefficientCount {
        /// The number given.
        given: usize,
        /// The number needed.
        needed: usize,
    },
    /// Operands from algebras with different metrics.
    DifferentAlgebras,
    /// The pseudoscalar has no inverse, so that no dual exists.
    Degenerate,
    /// The element has no inverse.
    NotInvertible,
    /// The element is neither even nor odd, so that it is no versor.
    MixedParity,
    /// The result is too large for the coefficient type, or an operand was not finite.
    NotFinite,
}

impl fmt::Display for DenseError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            DenseError::TooManyDimensions { dimension } => write!(
                f,
                "{dimension} dimensions are more than the {} supported by dense multivectors",
                super::Algebra::<i64>::MAX_DIMENSION
            ),
            DenseError::InnerProduct { row, column } => write!(
                f,
                "the inner product of basis vectors {row} and {column} does not fit the \
                 coefficient type"
            ),
            DenseError::NoSuchBlade(blade) => write!(
                f,
                "the blade with mask {:#b} has basis vectors beyond the dimension",
                blade.mask()
            ),
            DenseError::CoefficientCount { given, needed } => {
                write!(
                    f,
                    "{given} coefficients were given where {needed} are needed"
                )
            }
            DenseError::DifferentAlgebras => {
                write!(f, "the operands belong to algebras with different metrics")
            }
            DenseError::Degenerate => write!(f, "no dual exists in a degenerate metric"),
            DenseError::NotInvertible => write!(f, "the element has no inverse"),
            DenseError::MixedParity => {
                write!(f, "a versor must be even or odd, the element is neither")
            }
            DenseError::NotFinite => write!(f, "the result is not finite"),
        }
    }
}

impl core::error::Error for DenseError {}
