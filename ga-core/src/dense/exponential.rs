//! The exponential of any element by scaling and squaring.

use alloc::vec::Vec;

use super::{Algebra, Dense, DenseError};
use crate::{Blade, Real};

/// More halvings than any finite number of the supported types needs.
const MAX_HALVINGS: usize = 2200;
/// With a norm of at most 1/2 the series of double precision ends after some twenty terms.
const MAX_TERMS: i64 = 64;

impl<T: Real> Dense<T> {
    /// The exponential Σ Xᵏ/k! of any element: halved until its norm is at most 1/2, summed,
    /// squared as often as halved.
    ///
    /// # Errors
    /// [`DenseError::NotFinite`] where an operand is not finite or the result overflows.
    pub fn exp(&self) -> Result<Dense<T>, DenseError> {
        let half = T::from_ratio(1, 2);
        let mut scaled = self.clone();
        let mut norm = self.norm_bound();
        if !norm.is_finite() {
            return Err(DenseError::NotFinite);
        }
        let mut halvings = 0;
        while !norm.all_le(half) && halvings < MAX_HALVINGS {
            norm *= half;
            scaled = scaled.scale(half);
            halvings += 1;
        }
        let mut exponential = scaled.series();
        for _ in 0..halvings {
            exponential = exponential.times(&exponential);
            if !exponential.is_finite() {
                return Err(DenseError::NotFinite);
            }
        }
        Ok(exponential)
    }

    /// The power series, summed until it no longer changes.
    fn series(&self) -> Dense<T> {
        let mut sum = self.algebra().scalar(T::ONE);
        let mut term = sum.clone();
        for order in 1..=MAX_TERMS {
            term = term.times(self).scale(T::from_ratio(1, order));
            let next = sum.zip(&term, |a, b| a + b);
            if next == sum {
                break;
            }
            sum = next;
        }
        sum
    }

    /// Whether all coefficients are finite.
    pub fn is_finite(&self) -> bool {
        self.coefficients.iter().all(|value| value.is_finite())
    }

    /// A bound on the sum of absolute coefficients by which multiplication from the left by
    /// `self` can grow that of the other factor.
    fn norm_bound(&self) -> T {
        let weights = vector_bounds(self.algebra());
        let mut bound = T::ZERO;
        for (blade, value) in (0..).map(Blade::new).zip(&self.coefficients) {
            let vectors = blade.indices().filter_map(|index| weights.get(index));
            bound += vectors.fold(value.abs(), |product, &weight| product * weight);
        }
        bound
    }
}

/// The growth each basis vector can cause as a factor of an outer product: max(1, |eᵢ²|), and
/// twice the sum of |eᵢ·eⱼ| over the others, since (e_i ∧ Y) X = e_i (Y X) − (e_i ⌋ Y) X.
fn vector_bounds<T: Real>(algebra: &Algebra<T>) -> Vec<T> {
    let dimension = algebra.dimension();
    let rows = (0..dimension).map(|row| {
        let mut bound = T::ONE;
        for column in 0..dimension {
            let inner = algebra.gram()[row * dimension + column].abs();
            if column != row {
                bound += inner + inner;
            } else if !inner.all_le(T::ONE) {
                bound += inner;
            }
        }
        bound
    });
    rows.collect()
}
