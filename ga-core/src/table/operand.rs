//! Elements as lists of coefficients with their bitmasks, and back.

use crate::dual::{left_complement, right_complement};
use crate::ops::Element;
use crate::{Blade, Scalar};

/// The most blades of an algebra whose products loop: eight dimensions.
pub(super) const BLADES: usize = 256;

/// The coefficients of an element that can differ from zero.
pub(super) struct Operand<T> {
    terms: [(u32, T); BLADES],
    count: usize,
}

impl<T: Scalar> Operand<T> {
    /// The coefficients of an element, with fixed ones written by `number`.
    pub(super) fn of<A: Element<Number = T>>(a: &A, number: impl Fn(i64, i64) -> T) -> Self {
        let mut operand = Operand {
            terms: [(0, T::ZERO); BLADES],
            count: 0,
        };
        for (i, (blade, sign)) in A::BLADES.iter().enumerate() {
            operand.push(*blade, *sign, a.at(i));
        }
        for (blade, sign, numerator, denominator) in A::FIXED {
            operand.push(*blade, *sign, number(*numerator, *denominator));
        }
        operand
    }

    fn push(&mut self, blade: Blade, sign: i8, value: T) {
        if let Some(term) = self.terms.get_mut(self.count) {
            *term = (blade.mask(), if sign < 0 { -value } else { value });
            self.count += 1;
        }
    }

    /// Bitmasks and coefficients.
    pub(super) fn terms(&self) -> &[(u32, T)] {
        &self.terms[..self.count]
    }

    /// The right complement.
    pub(super) fn complements(mut self, dimension: usize) -> Self {
        for (mask, value) in &mut self.terms[..self.count] {
            let (blade, sign) = right_complement(dimension, Blade::new(*mask));
            *mask = blade.mask();
            *value = if sign < 0 { -*value } else { *value };
        }
        self
    }
}

/// The left complement of coefficients by bitmask.
pub(super) fn left_complements<T: Scalar>(dimension: usize, x: &[T; BLADES]) -> [T; BLADES] {
    let mut result = [T::ZERO; BLADES];
    for (mask, value) in (0..1_u32 << dimension).zip(x) {
        let (blade, sign) = left_complement(dimension, Blade::new(mask));
        result[blade.mask() as usize] = if sign < 0 { -*value } else { *value };
    }
    result
}

/// The element with these coefficients by bitmask.
pub(super) fn gather<R: Element>(coefficients: &[R::Number; BLADES]) -> R {
    R::from_fn(|i| {
        let (blade, sign) = R::BLADES[i];
        let value = coefficients[blade.mask() as usize];
        if sign < 0 { -value } else { value }
    })
}
