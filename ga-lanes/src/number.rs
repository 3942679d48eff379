//! Which lanes a number has on each target.

use ga_core::Real;

use crate::lanes::Lanes;
#[cfg(target_arch = "x86_64")]
use crate::lanes::instructions::Instructions;
#[cfg(target_arch = "x86_64")]
use crate::lanes::vector::Vector;
#[cfg(target_arch = "x86_64")]
use crate::target::{V3, V4};

/// The numbers that have lanes: `f32` and `f64`. Sealed.
pub trait Number: Real + Registers + Send + Sync {
    /// The lanes for every machine.
    type Portable: Lanes<Self>;
    /// A line of the cache.
    #[doc(hidden)]
    type Line: Copy + AsRef<[Self]> + Send + Sync;
    /// How many numbers a line of the cache holds: 64 bytes of them.
    const LINE: usize;
    /// A line of zeros.
    #[doc(hidden)]
    const ZERO_LINE: Self::Line;
}

/// What registers of the other targets hold this number.
#[cfg(target_arch = "x86_64")]
pub trait Registers: Instructions<V3> + Instructions<V4> {}
/// What registers of the other targets hold this number: there are none.
#[cfg(not(target_arch = "x86_64"))]
pub trait Registers {}

/// The lanes of x86-64-v3.
#[cfg(target_arch = "x86_64")]
pub(crate) type Wide<F> = Vector<F, V3>;
/// The lanes of x86-64-v4.
#[cfg(target_arch = "x86_64")]
pub(crate) type Widest<F> = Vector<F, V4>;

macro_rules! number {
    ($float:ident, $portable:ident, $count:literal) => {
        impl Registers for $float {}

        impl Number for $float {
            type Portable = wide::$portable;
            type Line = [$float; $count];
            const LINE: usize = $count;
            const ZERO_LINE: Self::Line = [0.0; $count];
        }
    };
}

number!(f32, f32x4, 16);
number!(f64, f64x2, 8);
