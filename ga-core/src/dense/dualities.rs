//! Complements, duals and the meet of dense multivectors.

use super::{Dense, DenseError};
use crate::{Blade, Field, Scalar};

impl<T: Scalar> Dense<T> {
    /// The right complement: e_S ∧ right_complement(e_S) = I.
    pub fn right_complement(&self) -> Dense<T> {
        self.complement(|blade, rest| is_odd(blade.indices().chain(rest.indices())))
    }

    /// The left complement: left_complement(e_S) ∧ e_S = I.
    pub fn left_complement(&self) -> Dense<T> {
        self.complement(|blade, rest| is_odd(rest.indices().chain(blade.indices())))
    }

    fn complement(&self, is_negative: impl Fn(Blade, Blade) -> bool) -> Dense<T> {
        let all = self.coefficients.len() - 1;
        let mut result = self.algebra().zero();
        for (mask, (blade, &value)) in (0..).map(Blade::new).zip(&self.coefficients).enumerate() {
            let rest = all - mask;
            // Masks of at most twelve bits.
            let negative = is_negative(blade, Blade::new(rest as u32));
            result.coefficients[rest] = if negative { -value } else { value };
        }
        result
    }

    /// The inverse of the dual, X I.
    pub fn undual(&self) -> Dense<T> {
        self.times(&self.algebra().pseudoscalar())
    }
}

/// Whether a list of different numbers is an odd permutation of the sorted one, by counting
/// the pairs out of order.
fn is_odd(list: impl Iterator<Item = usize> + Clone) -> bool {
    let later = list.clone().enumerate();
    let inversions: usize = later
        .map(|(position, first)| {
            let after = list.clone().skip(position + 1);
            after.filter(|&second| second < first).count()
        })
        .sum();
    !inversions.is_multiple_of(2)
}

impl<T: Field> Dense<T> {
    /// The dual X I⁻¹.
    ///
    /// # Errors
    /// [`DenseError::Degenerate`] where I² = 0.
    pub fn dual(&self) -> Result<Dense<T>, DenseError> {
        let pseudoscalar = self.algebra().pseudoscalar();
        let square = pseudoscalar.times(&pseudoscalar).coefficients[0];
        if !square.is_invertible() {
            return Err(DenseError::Degenerate);
        }
        Ok(self.undual().map(|_, value| value / square))
    }

    /// What two blades have in common, the inverse dual of the outer product of the duals
    /// (2.25). It differs from the regressive product by a sign.
    ///
    /// # Errors
    /// [`DenseError::Degenerate`] and [`DenseError::DifferentAlgebras`].
    pub fn meet(&self, other: &Dense<T>) -> Result<Dense<T>, DenseError> {
        Ok(self.dual()?.wedge(&other.dual()?)?.undual())
    }
}
