//! Integers and exact fractions. They overflow as the integers of the language do.

use num_rational::Ratio;

use super::{Field, Scalar};

impl Scalar for i64 {
    const ZERO: Self = 0;
    const ONE: Self = 1;

    fn from_integer(n: i64) -> Self {
        n
    }
}

macro_rules! fraction {
    ($integer:ident) => {
        impl Scalar for Ratio<$integer> {
            const ZERO: Self = Ratio::new_raw(0, 1);
            const ONE: Self = Ratio::new_raw(1, 1);

            fn from_integer(n: i64) -> Self {
                Ratio::from_integer(n.into())
            }
        }

        impl Field for Ratio<$integer> {
            /// Every fraction but zero and those whose reciprocal overflows.
            fn is_invertible(self) -> bool {
                *self.numer() != 0 && *self.numer() != $integer::MIN
            }

            fn from_ratio(numerator: i64, denominator: i64) -> Self {
                Ratio::new(numerator.into(), denominator.into())
            }
        }
    };
}

fraction!(i64);
fraction!(i128);
