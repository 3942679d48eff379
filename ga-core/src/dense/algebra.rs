//! A run-time algebra is a dimension and a Gram matrix in the coefficient type.

use alloc::sync::Arc;
use alloc::vec;
use alloc::vec::Vec;

use super::{Dense, DenseError};
use crate::{Blade, Field, Metric, Rational, Scalar};

/// An algebra over coefficients `T`; a cheap handle that its multivectors share.
#[derive(Clone, Debug)]
pub struct Algebra<T> {
    gram: Arc<[T]>,
    dimension: usize,
}

/// Two algebras are equal when their inner products are; names do not matter.
impl<T: PartialEq> PartialEq for Algebra<T> {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.gram, &other.gram) || self.gram == other.gram
    }
}

impl<T> Algebra<T> {
    /// The largest number of basis vectors: a multivector has 2ⁿ coefficients.
    pub const MAX_DIMENSION: usize = 12;

    /// The number of basis vectors.
    pub fn dimension(&self) -> usize {
        self.dimension
    }

    /// The inner products of the basis vectors, row after row.
    pub(super) fn gram(&self) -> &[T] {
        &self.gram
    }

    /// The number of coefficients of a multivector.
    pub(super) fn size(&self) -> usize {
        1 << self.dimension
    }

    fn convert(
        metric: &Metric,
        entry: impl Fn(i64, i64) -> Option<T>,
    ) -> Result<Algebra<T>, DenseError> {
        let dimension = metric.dimension();
        if dimension > Self::MAX_DIMENSION {
            return Err(DenseError::TooManyDimensions { dimension });
        }
        let convert = |exact: Rational| {
            let numerator = i64::try_from(*exact.numer()).ok()?;
            let denominator = i64::try_from(*exact.denom()).ok()?;
            entry(numerator, denominator)
        };
        let mut gram = Vec::with_capacity(dimension * dimension);
        for row in 0..dimension {
            for column in 0..dimension {
                let entry = convert(metric.gram(row, column));
                gram.push(entry.ok_or(DenseError::InnerProduct { row, column })?);
            }
        }
        let gram = gram.into();
        Ok(Algebra { gram, dimension })
    }
}

impl<T: Field> Algebra<T> {
    /// The algebra of a metric, over numbers that divide.
    ///
    /// # Errors
    /// [`DenseError::TooManyDimensions`] and [`DenseError::InnerProduct`].
    pub fn new(metric: &Metric) -> Result<Algebra<T>, DenseError> {
        Algebra::convert(metric, |numerator, denominator| {
            Some(T::from_ratio(numerator, denominator))
        })
    }
}

impl<T: Scalar> Algebra<T> {
    /// The algebra of a metric whose inner products are integers, over any ring.
    ///
    /// # Errors
    /// [`DenseError::TooManyDimensions`] and [`DenseError::InnerProduct`].
    pub fn integral(metric: &Metric) -> Result<Algebra<T>, DenseError> {
        Algebra::convert(metric, |numerator, denominator| {
            (denominator == 1).then(|| T::from_integer(numerator))
        })
    }

    /// The multivector 0.
    pub fn zero(&self) -> Dense<T> {
        Dense::new(self.clone(), vec![T::ZERO; self.size()])
    }

    /// A scalar as a multivector.
    pub fn scalar(&self, value: T) -> Dense<T> {
        let mut scalar = self.zero();
        scalar.coefficients[0] = value;
        scalar
    }

    /// A multiple of a basis blade.
    ///
    /// # Errors
    /// [`DenseError::NoSuchBlade`].
    pub fn blade(&self, blade: Blade, value: T) -> Result<Dense<T>, DenseError> {
        self.from_terms([(blade, value)])
    }

    /// The outer product of all basis vectors, I.
    pub fn pseudoscalar(&self) -> Dense<T> {
        let mut pseudoscalar = self.zero();
        pseudoscalar.coefficients[self.size() - 1] = T::ONE;
        pseudoscalar
    }

    /// The vector with these components.
    ///
    /// # Errors
    /// [`DenseError::CoefficientCount`] unless there is one component for each basis vector.
    pub fn vector(&self, components: &[T]) -> Result<Dense<T>, DenseError> {
        check_count(components.len(), self.dimension)?;
        let blades = (0..self.dimension).map(|index| Blade::new(1 << index));
        self.from_terms(blades.zip(components.iter().copied()))
    }

    /// The sum of multiples of basis blades; a blade may occur several times.
    ///
    /// # Errors
    /// [`DenseError::NoSuchBlade`].
    pub fn from_terms(
        &self,
        terms: impl IntoIterator<Item = (Blade, T)>,
    ) -> Result<Dense<T>, DenseError> {
        let mut sum = self.zero();
        for (blade, value) in terms {
            let coefficient = sum
                .coefficients
                .get_mut(blade.mask() as usize)
                .ok_or(DenseError::NoSuchBlade(blade))?;
            *coefficient += value;
        }
        Ok(sum)
    }

    /// The multivector with these coefficients, in order of blade masks: 1, e1, e2, e12, e3, …
    ///
    /// # Errors
    /// [`DenseError::CoefficientCount`] unless there are 2ⁿ of them.
    pub fn from_coefficients(&self, coefficients: Vec<T>) -> Result<Dense<T>, DenseError> {
        check_count(coefficients.len(), self.size())?;
        Ok(Dense::new(self.clone(), coefficients))
    }
}

fn check_count(given: usize, needed: usize) -> Result<(), DenseError> {
    if given == needed {
        Ok(())
    } else {
        Err(DenseError::CoefficientCount { given, needed })
    }
}
