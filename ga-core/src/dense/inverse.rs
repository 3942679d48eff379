//! The inverse of any element, and versor application, which needs it.

use super::{Dense, DenseError};
use crate::{Field, Scalar};

impl<T: Field> Dense<T> {
    /// The inverse of any invertible element in any metric, by the method of Faddeev and
    /// LeVerrier with N = 2^⌈n/2⌉ steps; polished by one Newton step from six dimensions on,
    /// where rounding would show.
    ///
    /// # Errors
    /// [`DenseError::NotInvertible`] where the determinant is zero. With rounded coefficients
    /// the determinant of a null element may come out tiny instead.
    pub fn inverse(&self) -> Result<Dense<T>, DenseError> {
        let algebra = self.algebra();
        let dimension = algebra.dimension();
        let steps = 1_i64 << dimension.div_ceil(2);
        let mut adjugate = algebra.scalar(T::ONE);
        let mut product = self.clone();
        for step in 1..steps {
            let coefficient = T::from_ratio(steps, step) * product.coefficients[0];
            adjugate = product;
            adjugate.coefficients[0] -= coefficient;
            product = self.times(&adjugate);
        }
        let determinant = product.coefficients[0];
        if !determinant.is_invertible() {
            return Err(DenseError::NotInvertible);
        }
        let inverse = adjugate.map(|_, value| value / determinant);
        if dimension < 6 {
            return Ok(inverse);
        }
        let mut correction = self.times(&inverse).scale(-T::ONE);
        correction.coefficients[0] += T::from_integer(2);
        Ok(inverse.times(&correction))
    }

    /// The versor `self` applied to `x`: V x V⁻¹, with the grade involution of `x` for odd V
    /// (2.28).
    ///
    /// # Errors
    /// [`DenseError::MixedParity`], [`DenseError::NotInvertible`] and
    /// [`DenseError::DifferentAlgebras`]. An invertible element of one parity that is no versor
    /// is not detected: its result need not keep the grade of `x`.
    pub fn apply(&self, x: &Dense<T>) -> Result<Dense<T>, DenseError> {
        self.check_same(x)?;
        let operand = match self.parity() {
            Some(Parity::Even) => x.clone(),
            Some(Parity::Odd) => x.involute(),
            None => return Err(DenseError::MixedParity),
        };
        Ok(self.times(&operand).times(&self.versor_inverse()?))
    }

    /// The reverse divided by V Ṽ where that is exactly a scalar, the general inverse elsewhere.
    fn versor_inverse(&self) -> Result<Dense<T>, DenseError> {
        let reverse = self.reverse();
        let square = self.times(&reverse);
        let scalar = square.coefficients[0];
        let others_vanish = square.coefficients[1..]
            .iter()
            .all(|&value| value == T::ZERO);
        if others_vanish && scalar.is_invertible() {
            return Ok(reverse.map(|_, value| value / scalar));
        }
        self.inverse()
    }
}

enum Parity {
    Even,
    Odd,
}

impl<T: Scalar> Dense<T> {
    /// Whether only even or only odd grades occur; zero counts as even.
    fn parity(&self) -> Option<Parity> {
        let terms = self.terms();
        let odd = terms
            .iter()
            .filter(|(blade, _)| blade.grade() % 2 == 1)
            .count();
        match odd {
            0 => Some(Parity::Even),
            _ if odd == terms.len() => Some(Parity::Odd),
            _ => None,
        }
    }
}
