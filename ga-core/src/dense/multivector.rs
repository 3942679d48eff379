//! A dense multivector: its coefficients and everything that treats them one by one.

use alloc::vec::Vec;

use super::{Algebra, DenseError};
use crate::{Blade, Scalar};

/// A multivector with one coefficient for every basis blade of its algebra.
#[derive(Clone, Debug, PartialEq)]
pub struct Dense<T> {
    algebra: Algebra<T>,
    /// As many as the algebra has blades, in order of masks.
    pub(super) coefficients: Vec<T>,
}

impl<T> Dense<T> {
    pub(super) fn new(algebra: Algebra<T>, coefficients: Vec<T>) -> Dense<T> {
        Dense {
            algebra,
            coefficients,
        }
    }

    /// The algebra it belongs to.
    pub fn algebra(&self) -> &Algebra<T> {
        &self.algebra
    }

    /// The coefficients in order of blade masks: 1, e1, e2, e12, e3, …
    pub fn coefficients(&self) -> &[T] {
        &self.coefficients
    }
}

impl<T: Scalar> Dense<T> {
    /// The coefficient of a blade; zero for a blade beyond the dimension.
    pub fn coefficient(&self, blade: Blade) -> T {
        let coefficient = self.coefficients.get(blade.mask() as usize);
        coefficient.copied().unwrap_or(T::ZERO)
    }

    /// The blades whose coefficients are not zero, with these, in blade order.
    pub fn terms(&self) -> Vec<(Blade, T)> {
        let blades = (0..).map(Blade::new);
        let mut terms: Vec<(Blade, T)> = blades.zip(self.coefficients.iter().copied()).collect();
        terms.retain(|&(_, coefficient)| coefficient != T::ZERO);
        terms.sort_by_key(|&(blade, _)| blade);
        terms
    }

    /// Whether all coefficients are zero.
    pub fn is_zero(&self) -> bool {
        self.coefficients.iter().all(|&value| value == T::ZERO)
    }

    /// The sum.
    ///
    /// # Errors
    /// [`DenseError::DifferentAlgebras`].
    pub fn add(&self, other: &Dense<T>) -> Result<Dense<T>, DenseError> {
        self.check_same(other)?;
        Ok(self.zip(other, |a, b| a + b))
    }

    /// The difference.
    ///
    /// # Errors
    /// [`DenseError::DifferentAlgebras`].
    pub fn sub(&self, other: &Dense<T>) -> Result<Dense<T>, DenseError> {
        self.check_same(other)?;
        Ok(self.zip(other, |a, b| a - b))
    }

    /// Every coefficient times `factor`.
    pub fn scale(&self, factor: T) -> Dense<T> {
        self.map(|_, value| value * factor)
    }

    /// The part of grade `grade`, ⟨X⟩ₖ; zero beyond the dimension.
    pub fn grade(&self, grade: u32) -> Dense<T> {
        self.map(|blade, value| {
            if blade.grade() == grade {
                value
            } else {
                T::ZERO
            }
        })
    }

    /// The reverse, (−1)^{k(k−1)/2} on grade k (2.22 with the exponent halved).
    pub fn reverse(&self) -> Dense<T> {
        self.signed(|k| k * k.saturating_sub(1) / 2)
    }

    /// The grade involution, (−1)^k on grade k (2.23).
    pub fn involute(&self) -> Dense<T> {
        self.signed(|k| k)
    }

    /// The Clifford conjugate, (−1)^{k(k+1)/2} on grade k (2.24 with the exponent halved).
    pub fn conjugate(&self) -> Dense<T> {
        self.signed(|k| k * (k + 1) / 2)
    }

    fn signed(&self, exponent: impl Fn(u32) -> u32) -> Dense<T> {
        self.map(|blade, value| {
            if exponent(blade.grade()).is_multiple_of(2) {
                value
            } else {
                -value
            }
        })
    }

    pub(super) fn map(&self, change: impl Fn(Blade, T) -> T) -> Dense<T> {
        let blades = (0..).map(Blade::new);
        let changed = blades.zip(&self.coefficients);
        let coefficients = changed
            .map(|(blade, &value)| change(blade, value))
            .collect();
        Dense::new(self.algebra.clone(), coefficients)
    }

    /// Coefficient by coefficient; both operands belong to one algebra.
    pub(super) fn zip(&self, other: &Dense<T>, join: impl Fn(T, T) -> T) -> Dense<T> {
        let pairs = self.coefficients.iter().zip(&other.coefficients);
        let coefficients = pairs.map(|(&a, &b)| join(a, b)).collect();
        Dense::new(self.algebra.clone(), coefficients)
    }

    pub(super) fn check_same(&self, other: &Dense<T>) -> Result<(), DenseError> {
        if self.algebra == other.algebra {
            Ok(())
        } else {
            Err(DenseError::DifferentAlgebras)
        }
    }
}
