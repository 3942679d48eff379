//! How many multiply-add slots an operation takes at least: it is run on numbers that count.

use std::cell::Cell;
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use ga_core::{Field, Scalar};

thread_local! {
    static SLOTS: Cell<u32> = const { Cell::new(0) };
}

/// The slots of a computation: one each for a product, a sum, or both in one. A change of sign
/// takes none, because it is part of the next operation or runs beside.
pub fn slots<X>(computation: impl FnOnce() -> X) -> u32 {
    SLOTS.set(0);
    computation();
    SLOTS.get()
}

fn take(value: f64) -> Slot {
    SLOTS.set(SLOTS.get() + 1);
    Slot(value)
}

/// A number whose operations are counted.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Slot(pub f64);

impl Scalar for Slot {
    const ZERO: Self = Slot(0.0);
    const ONE: Self = Slot(1.0);

    fn from_integer(n: i64) -> Self {
        Slot(n as f64)
    }

    fn plus_product(self, a: Self, b: Self) -> Self {
        take(self.0 + a.0 * b.0)
    }

    fn minus_product(self, a: Self, b: Self) -> Self {
        take(self.0 - a.0 * b.0)
    }
}

impl Field for Slot {
    fn is_invertible(self) -> bool {
        self.0 != 0.0
    }

    fn from_ratio(numerator: i64, denominator: i64) -> Self {
        Slot(numerator as f64 / denominator as f64)
    }
}

impl Neg for Slot {
    type Output = Self;

    fn neg(self) -> Self {
        Slot(-self.0)
    }
}

macro_rules! counted {
    ($($Trait:ident $method:ident $Assign:ident $assign:ident $operator:tt)*) => {$(
        impl $Trait for Slot {
            type Output = Self;

            fn $method(self, other: Self) -> Self {
                take(self.0 $operator other.0)
            }
        }

        impl $Assign for Slot {
            fn $assign(&mut self, other: Self) {
                *self = *self $operator other;
            }
        }
    )*};
}

counted! {
    Add add AddAssign add_assign +
    Sub sub SubAssign sub_assign -
    Mul mul MulAssign mul_assign *
    Div div DivAssign div_assign /
}
