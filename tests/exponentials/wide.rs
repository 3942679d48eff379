//! Numbers of 32 digits, in which the oracle computes.

use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use ga::core::{Field, Scalar};
use twofloat::TwoFloat;

/// A number as the sum of two of double precision.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Wide(TwoFloat);

impl Wide {
    /// The nearest number of double precision.
    pub fn to_f64(self) -> f64 {
        self.0.hi() + self.0.lo()
    }

    /// The square root, by one step of Newton's iteration from that of double precision.
    pub fn sqrt(self) -> Wide {
        let root = self.to_f64().sqrt();
        if root == 0.0 {
            return Wide::ZERO;
        }
        let root = Wide::from(root);
        (root + self / root) * Wide::from(0.5)
    }
}

impl From<f64> for Wide {
    fn from(value: f64) -> Wide {
        Wide(TwoFloat::from(value))
    }
}

macro_rules! operations {
    ($($trait:ident $method:ident, $assign:ident $assigned:ident;)*) => {$(
        impl $trait for Wide {
            type Output = Wide;
            fn $method(self, other: Wide) -> Wide {
                Wide(self.0.$method(other.0))
            }
        }
        impl $assign for Wide {
            fn $assigned(&mut self, other: Wide) {
                *self = self.$method(other);
            }
        }
    )*};
}

operations! {
    Add add, AddAssign add_assign;
    Sub sub, SubAssign sub_assign;
    Mul mul, MulAssign mul_assign;
    Div div, DivAssign div_assign;
}

impl Neg for Wide {
    type Output = Wide;
    fn neg(self) -> Wide {
        Wide(-self.0)
    }
}

impl Scalar for Wide {
    const ZERO: Wide = Wide(TwoFloat::from_f64(0.0));
    const ONE: Wide = Wide(TwoFloat::from_f64(1.0));

    fn from_integer(n: i64) -> Wide {
        Wide::from(n as f64)
    }
}

impl Field for Wide {
    fn is_invertible(self) -> bool {
        self.to_f64().is_invertible()
    }
}
