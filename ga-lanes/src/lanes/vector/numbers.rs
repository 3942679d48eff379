//! The ring and field operations of vectors; why they are sound is said in the module above.

use core::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use ga_core::{Field, Narrowing, Real, Scalar};

use super::{Instructions, Vector};

macro_rules! operators {
    ($($operator:ident $method:ident $instruction:ident $assign:ident $in_place:ident;)*) => {$(
        impl<F: Instructions<C>, C> $operator for Vector<F, C> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                // SAFETY: two vectors exist; see above.
                Vector(unsafe { F::$instruction(self.0, other.0) })
            }
        }

        impl<F: Instructions<C>, C> $assign for Vector<F, C> {
            #[inline(always)]
            fn $in_place(&mut self, other: Self) {
                *self = $operator::$method(*self, other);
            }
        }
    )*};
}

operators! {
    Add add sum AddAssign add_assign;
    Sub sub difference SubAssign sub_assign;
    Mul mul product MulAssign mul_assign;
    Div div ratio DivAssign div_assign;
}

impl<F: Instructions<C>, C> Neg for Vector<F, C> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        // SAFETY: a vector exists; see above.
        Vector(unsafe { F::xor(self.0, F::SIGNS) })
    }
}

impl<F: Instructions<C>, C: 'static> Scalar for Vector<F, C> {
    const ZERO: Self = Vector(F::ZEROS);
    const ONE: Self = Vector(F::ONES);
    const HALF: Option<Self> = Some(Vector(F::HALVES));

    #[inline(always)]
    fn from_integer(n: i64) -> Self {
        ga_core::Lanes::splat(F::from_integer(n))
    }

    #[inline(always)]
    fn plus_product(self, a: Self, b: Self) -> Self {
        // SAFETY: three vectors exist; see above.
        Vector(unsafe { F::product_plus(a.0, b.0, self.0) })
    }

    #[inline(always)]
    fn minus_product(self, a: Self, b: Self) -> Self {
        // SAFETY: three vectors exist; see above.
        Vector(unsafe { F::minus_product_plus(a.0, b.0, self.0) })
    }
}

impl<F: Instructions<C>, C: 'static> Field for Vector<F, C> {
    #[inline(always)]
    fn is_invertible(self) -> bool {
        self.is_finite() && (Self::ONE / self).is_finite()
    }

    #[inline(always)]
    fn from_ratio(numerator: i64, denominator: i64) -> Self {
        ga_core::Lanes::splat(F::from_ratio(numerator, denominator))
    }

    #[inline(always)]
    fn negligible_beside(coefficients: impl Iterator<Item = Self>) -> Self {
        let largest = coefficients.fold(Self::ZERO, |largest, x| {
            let size = Real::abs(x);
            size.select_le(largest, largest, size)
        });
        largest * Self::from_f64(Narrowing::TOLERANCE)
    }

    #[inline(always)]
    fn is_within(self, bound: Self) -> bool {
        bound.is_finite() && Real::abs(self).all_le(bound)
    }
}
