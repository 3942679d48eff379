//! All products of dense multivectors, each by its definition through grade parts.

use alloc::vec;

use super::multiply::multiply;
use super::{Dense, DenseError};
use crate::{Field, Product, Scalar};

impl<T: Scalar> Dense<T> {
    /// The geometric product.
    ///
    /// # Errors
    /// [`DenseError::DifferentAlgebras`], as for every product.
    pub fn geometric(&self, other: &Dense<T>) -> Result<Dense<T>, DenseError> {
        self.check_same(other)?;
        Ok(self.times(other))
    }

    /// The outer product: the geometric product in the metric whose inner products all vanish.
    ///
    /// # Errors
    /// [`DenseError::DifferentAlgebras`].
    pub fn wedge(&self, other: &Dense<T>) -> Result<Dense<T>, DenseError> {
        self.check_same(other)?;
        let dimension = self.algebra().dimension();
        let gram = vec![T::ZERO; dimension * dimension];
        let product = multiply(&gram, dimension, &self.coefficients, &other.coefficients);
        Ok(Dense::new(self.algebra().clone(), product))
    }

    /// The left contraction Σ ⟨aᵣ bₛ⟩ of grade s − r.
    ///
    /// # Errors
    /// [`DenseError::DifferentAlgebras`].
    pub fn left_contract(&self, other: &Dense<T>) -> Result<Dense<T>, DenseError> {
        self.graded(other, |r, s| s.checked_sub(r))
    }

    /// The right contraction Σ ⟨aᵣ bₛ⟩ of grade r − s.
    ///
    /// # Errors
    /// [`DenseError::DifferentAlgebras`].
    pub fn right_contract(&self, other: &Dense<T>) -> Result<Dense<T>, DenseError> {
        self.graded(other, |r, s| r.checked_sub(s))
    }

    /// The inner product Σ ⟨aᵣ bₛ⟩ of grade |r − s| over r, s > 0 (2.71).
    ///
    /// # Errors
    /// [`DenseError::DifferentAlgebras`].
    pub fn inner(&self, other: &Dense<T>) -> Result<Dense<T>, DenseError> {
        self.graded(other, |r, s| (r > 0 && s > 0).then_some(r.abs_diff(s)))
    }

    /// The scalar product ⟨a b⟩, as a multivector.
    ///
    /// # Errors
    /// [`DenseError::DifferentAlgebras`].
    pub fn scalar_product(&self, other: &Dense<T>) -> Result<Dense<T>, DenseError> {
        Ok(self.geometric(other)?.grade(0))
    }

    /// The regressive product, the left complement of the outer product of right complements.
    ///
    /// # Errors
    /// [`DenseError::DifferentAlgebras`].
    pub fn regressive(&self, other: &Dense<T>) -> Result<Dense<T>, DenseError> {
        let spanned = self.right_complement().wedge(&other.right_complement())?;
        Ok(spanned.left_complement())
    }

    /// ⟨X X̃⟩ with its sign.
    pub fn norm_squared(&self) -> T {
        self.times(&self.reverse()).coefficients[0]
    }

    /// The geometric product within one algebra.
    pub(super) fn times(&self, other: &Dense<T>) -> Dense<T> {
        let algebra = self.algebra();
        let (left, right) = (&self.coefficients, &other.coefficients);
        let product = multiply(algebra.gram(), algebra.dimension(), left, right);
        Dense::new(algebra.clone(), product)
    }

    /// The sum, over the grade parts of both sides, of the part that `wanted` names of their
    /// product.
    fn graded(
        &self,
        other: &Dense<T>,
        wanted: impl Fn(u32, u32) -> Option<u32>,
    ) -> Result<Dense<T>, DenseError> {
        self.check_same(other)?;
        let mut sum = self.algebra().zero();
        for (r, left) in self.grade_parts() {
            for (s, right) in other.grade_parts() {
                if let Some(grade) = wanted(r, s) {
                    sum = sum.zip(&left.times(&right).grade(grade), |a, b| a + b);
                }
            }
        }
        Ok(sum)
    }

    /// The grades that occur and their parts.
    fn grade_parts(&self) -> impl Iterator<Item = (u32, Dense<T>)> {
        let grades = (0..).take(self.algebra().dimension() + 1);
        let parts = grades.map(|grade| (grade, self.grade(grade)));
        parts.filter(|(_, part)| !part.is_zero())
    }
}

impl<T: Field> Dense<T> {
    /// The commutator product (ab − ba)/2.
    ///
    /// # Errors
    /// [`DenseError::DifferentAlgebras`].
    pub fn commutator(&self, other: &Dense<T>) -> Result<Dense<T>, DenseError> {
        let difference = self.geometric(other)?.sub(&other.times(self))?;
        Ok(difference.scale(T::from_ratio(1, 2)))
    }

    /// The anticommutator product (ab + ba)/2.
    ///
    /// # Errors
    /// [`DenseError::DifferentAlgebras`].
    pub fn anticommutator(&self, other: &Dense<T>) -> Result<Dense<T>, DenseError> {
        let sum = self.geometric(other)?.add(&other.times(self))?;
        Ok(sum.scale(T::from_ratio(1, 2)))
    }

    /// Any product of the table.
    ///
    /// # Errors
    /// [`DenseError::DifferentAlgebras`].
    pub fn product(&self, which: Product, other: &Dense<T>) -> Result<Dense<T>, DenseError> {
        match which {
            Product::Geometric => self.geometric(other),
            Product::Wedge => self.wedge(other),
            Product::LeftContract => self.left_contract(other),
            Product::RightContract => self.right_contract(other),
            Product::Inner => self.inner(other),
            Product::ScalarProduct => self.scalar_product(other),
            Product::Regressive => self.regressive(other),
            Product::Commutator => self.commutator(other),
            Product::Anticommutator => self.anticommutator(other),
        }
    }
}
