//! The numbers that coefficients are made of: ring, field and real operations.

mod dual_number;
#[cfg(any(feature = "std", feature = "libm"))]
mod elementary;
mod exact;
mod float;
#[cfg(any(feature = "std", feature = "libm"))]
mod functions;
#[cfg(any(feature = "std", feature = "libm"))]
mod lanes;
#[cfg(feature = "wide")]
mod packs;
#[cfg(any(feature = "std", feature = "libm"))]
mod precision;
#[cfg(any(feature = "std", feature = "libm"))]
mod real;
mod slopes;

use core::fmt::Debug;
use core::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

pub use dual_number::Dual;
#[cfg(any(feature = "std", feature = "libm"))]
pub use lanes::Lanes;
#[cfg(any(feature = "std", feature = "libm"))]
pub use precision::Precision;

/// A commutative ring: what sums and products of multivectors need.
///
/// Implemented for `f32`, `f64`, `i64`, exact rationals (`Ratio<i64>`, `Ratio<i128>`),
/// SIMD lanes (`wide`, feature `wide`) and [`Dual`] numbers.
pub trait Scalar:
    Copy
    + Debug
    + Default
    + PartialEq
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Neg<Output = Self>
    + AddAssign
    + SubAssign
    + MulAssign
    + 'static
{
    /// The neutral element of addition.
    const ZERO: Self;
    /// The neutral element of multiplication.
    const ONE: Self;

    /// The number ½ where results may be rounded; `None` for exact numbers.
    ///
    /// Numbers that round take the fast way of long products, through matrices
    /// ([`matrix`](crate::matrix)), which needs halves and gives zeros up to rounding only. All
    /// others are multiplied term by term.
    const HALF: Option<Self> = None;

    /// The integer `n` as an element of the ring, rounded as the ring rounds.
    fn from_integer(n: i64) -> Self;

    /// `self + a b`, rounded once where the target multiplies and adds in one instruction.
    #[inline(always)]
    fn plus_product(self, a: Self, b: Self) -> Self {
        self + a * b
    }

    /// `self − a b`, rounded once where the target multiplies and adds in one instruction.
    #[inline(always)]
    fn minus_product(self, a: Self, b: Self) -> Self {
        self - a * b
    }
}

/// A [`Scalar`] that divides: what inverses and metrics with fractional entries need.
///
/// Division by zero follows the type: floats give infinities, exact rationals panic as
/// integers do. Code that must not meet it asks [`is_invertible`](Field::is_invertible) first.
pub trait Field: Scalar + Div<Output = Self> + DivAssign {
    /// Whether `1 / self` exists; on lanes, whether it exists in every lane.
    fn is_invertible(self) -> bool;

    /// The fraction `numerator / denominator`.
    fn from_ratio(numerator: i64, denominator: i64) -> Self {
        Self::from_integer(numerator) / Self::from_integer(denominator)
    }

    /// How far from its value a coefficient may be for `TryFrom` to take it for that value, beside
    /// these coefficients: not at all for exact numbers,
    /// [`Narrowing::TOLERANCE`](crate::Narrowing::TOLERANCE) times the largest for those that
    /// round.
    fn negligible_beside(_: impl Iterator<Item = Self>) -> Self {
        Self::ZERO
    }

    /// Whether this difference is within a bound that [`negligible_beside`](Field::negligible_beside)
    /// gave; on lanes, whether it is in every lane. Nothing is within a bound that is not finite.
    fn is_within(self, _: Self) -> bool {
        self == Self::ZERO
    }
}

/// A computation that can be put into a function of its own, with [`Real::outlined`].
pub trait Computation {
    /// What it gives.
    type Output;
    /// The computation. Lanes want it inlined whatever its length.
    fn run(self) -> Self::Output;
}

/// A computation in a function of its own.
#[inline(never)]
fn outlined<C: Computation>(computation: C) -> C::Output {
    computation.run()
}

/// A [`Field`] with roots and transcendental functions: what norms, exponentials and
/// logarithms need.
///
/// A predicate on lanes holds when it holds in every lane. Floats and lanes of them are real
/// numbers with the feature `std` or `libm`; every type of [`Lanes`] is.
pub trait Real: Field {
    /// The circle constant π.
    const PI: Self;
    /// The distance from 1 to the next larger number.
    const EPSILON: Self;

    /// A value given in double precision, rounded to this type.
    fn from_f64(value: f64) -> Self;
    /// The number `value` with the derivatives of this one: `value` itself, except for
    /// [`Dual`] numbers.
    fn at_value(self, value: Self) -> Self;
    /// The absolute value.
    fn abs(self) -> Self;
    /// The square root; of a negative value not a number, as in `f64`.
    fn sqrt(self) -> Self;
    /// Sine and cosine of an angle in radians.
    fn sin_cos(self) -> (Self, Self);
    /// The angle of the point (`x`, `self`) in radians, in (−π, π].
    fn atan2(self, x: Self) -> Self;
    /// The exponential function.
    fn exp(self) -> Self;
    /// The natural logarithm.
    fn ln(self) -> Self;

    /// The entire functions `C(a) = cosh √a` and `S(a) = sinh √a / √a`, continued to negative
    /// `a` as `cos √−a` and `sin √−a / √−a`, so that `exp B = C(B²) + S(B²) B` for every
    /// bivector whose square is a scalar (2.62). Smooth at zero, where both are 1.
    fn cosh_sinhc(self) -> (Self, Self);

    /// C, S and the derivative S′; that of C is S/2.
    fn cosh_sinhc_slope(self) -> (Self, Self, Self) {
        let (cosh, sinhc) = self.cosh_sinhc();
        (cosh, sinhc, slopes::sinhc_slope(self, cosh, sinhc))
    }

    /// The factor `f` for which `log(c + X) = f X`, given the scalar part `c` = `self` and
    /// `square` = X², where c² − X² = 1 (2.69 with the sign of `c` respected).
    ///
    /// `None` where no real logarithm exists: `c ≤ 0` with `square ≥ 0`, an input that is
    /// not finite, or one where c² − X² is not even roughly 1. For lanes all lanes must exist.
    fn log_factor(self, square: Self) -> Option<Self>;

    /// The factor `f` and its derivative by `c` along c² − X² = 1.
    fn log_factor_slope(self, square: Self) -> Option<(Self, Self)> {
        let factor = self.log_factor(square)?;
        Some((factor, slopes::log_factor_slope(self, square, factor)))
    }

    /// Whether every lane is a finite number.
    fn is_finite(self) -> bool;
    /// Whether `self ≤ other` in every lane.
    fn all_le(self, other: Self) -> bool;
    /// Lane by lane: `then` where `self ≤ bound`, `otherwise` elsewhere.
    fn select_le(self, bound: Self, then: Self, otherwise: Self) -> Self;

    /// A computation that is seldom needed, in a function of its own: it leaves the registers to
    /// what is always needed, and uses the same instructions.
    #[inline(always)]
    fn outlined<C: Computation>(computation: C) -> C::Output {
        outlined(computation)
    }
}
