//! Numbers that compute as floats do but say nothing of halves: products of them are term by
//! term.

use std::ops::{Add, AddAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use ga::core::Scalar;

/// A number whose products are term by term.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Direct<T>(T);

macro_rules! operators {
    ($($Operator:ident $operate:ident $Assign:ident $assign:ident)*) => {$(
        impl<T: Scalar> $Operator for Direct<T> {
            type Output = Self;
            #[inline(always)]
            fn $operate(self, other: Self) -> Self {
                Direct(self.0.$operate(other.0))
            }
        }

        impl<T: Scalar> $Assign for Direct<T> {
            #[inline(always)]
            fn $assign(&mut self, other: Self) {
                self.0.$assign(other.0);
            }
        }
    )*};
}

operators! {
    Add add AddAssign add_assign
    Sub sub SubAssign sub_assign
    Mul mul MulAssign mul_assign
}

impl<T: Scalar> Neg for Direct<T> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Direct(-self.0)
    }
}

impl<T: Scalar> Scalar for Direct<T> {
    const ZERO: Self = Direct(T::ZERO);
    const ONE: Self = Direct(T::ONE);

    fn from_integer(n: i64) -> Self {
        Direct(T::from_integer(n))
    }

    #[inline(always)]
    fn plus_product(self, a: Self, b: Self) -> Self {
        Direct(self.0.plus_product(a.0, b.0))
    }

    #[inline(always)]
    fn minus_product(self, a: Self, b: Self) -> Self {
        Direct(self.0.minus_product(a.0, b.0))
    }
}
