//! Numbers in one vector register: the ring, field and real operations by the instructions of a
//! target.
//!
//! # Safety
//! The operators are safe to call, as the traits of ga-core want them, and execute instructions
//! that a machine may lack. They are sound because a [`Vector`] cannot be had, nor its type be
//! named, outside a kernel: this module is private, no public item has the type as an associated
//! one, and [`dispatch`](crate::dispatch) runs kernels only on targets that the machine was found
//! to have. What a kernel smuggles out in a box stays on that machine.

use core::fmt;
use core::ops::{Add, AddAssign, BitAnd, BitOr, Div, DivAssign, Mul, MulAssign};
use core::ops::{Neg, Not, Sub, SubAssign};

use ga_core::{Field, Lanes as _, Narrowing, Precision, Real, Scalar};

use super::{Lanes, sealed};

/// The instructions of target `C` for numbers of this type.
///
/// # Safety
/// Every unsafe function may be called only on a machine that has the target's instructions.
pub trait Instructions<C>: Precision {
    /// A vector register.
    type Register: Copy + 'static;
    /// The outcome of a comparison.
    type Outcome: Copy + 'static;
    /// The numbers of a register in memory.
    type Array: Copy + AsRef<[Self]> + AsMut<[Self]>;
    /// How many numbers a register holds.
    const COUNT: usize;
    /// What is added to the exponent of a number where it is stored.
    const BIAS: Self;
    /// 0 in every lane.
    const ZEROS: Self::Register;
    /// 1 in every lane.
    const ONES: Self::Register;
    /// π in every lane.
    const PIS: Self::Register;
    /// The rounding of 1 in every lane.
    const EPSILONS: Self::Register;
    /// The bit of the sign in every lane.
    const SIGNS: Self::Register;
    /// All other bits.
    const MAGNITUDES: Self::Register;
    /// The bits of the mantissa.
    const MANTISSAS: Self::Register;

    /// The arrays of a slice.
    fn arrays(numbers: &[Self]) -> &[Self::Array];
    /// The arrays of a slice, to be written.
    fn arrays_mut(numbers: &mut [Self]) -> &mut [Self::Array];
    /// The array of a function's values.
    fn array(lane: impl FnMut(usize) -> Self) -> Self::Array;
    /// One number in every lane.
    unsafe fn same(value: Self) -> Self::Register;
    /// From memory.
    unsafe fn load(array: &Self::Array) -> Self::Register;
    /// To memory.
    unsafe fn store(array: &mut Self::Array, a: Self::Register);
    /// a + b
    unsafe fn sum(a: Self::Register, b: Self::Register) -> Self::Register;
    /// a − b
    unsafe fn difference(a: Self::Register, b: Self::Register) -> Self::Register;
    /// a b
    unsafe fn product(a: Self::Register, b: Self::Register) -> Self::Register;
    /// a / b
    unsafe fn ratio(a: Self::Register, b: Self::Register) -> Self::Register;
    /// a b + c, rounded once
    unsafe fn product_plus(
        a: Self::Register,
        b: Self::Register,
        c: Self::Register,
    ) -> Self::Register;
    /// c − a b, rounded once
    unsafe fn minus_product_plus(
        a: Self::Register,
        b: Self::Register,
        c: Self::Register,
    ) -> Self::Register;
    /// √a
    unsafe fn root(a: Self::Register) -> Self::Register;
    /// The bits of both.
    unsafe fn and(a: Self::Register, b: Self::Register) -> Self::Register;
    /// The bits of either.
    unsafe fn or(a: Self::Register, b: Self::Register) -> Self::Register;
    /// The bits in which they differ.
    unsafe fn xor(a: Self::Register, b: Self::Register) -> Self::Register;
    /// The bits moved up by the length of the mantissa.
    unsafe fn shift_up(a: Self::Register) -> Self::Register;
    /// The bits moved down by the length of the mantissa.
    unsafe fn shift_down(a: Self::Register) -> Self::Register;
    /// Where a < b
    unsafe fn less(a: Self::Register, b: Self::Register) -> Self::Outcome;
    /// Where a ≤ b
    unsafe fn at_most(a: Self::Register, b: Self::Register) -> Self::Outcome;
    /// Where both hold.
    unsafe fn mask_and(a: Self::Outcome, b: Self::Outcome) -> Self::Outcome;
    /// Where either holds.
    unsafe fn mask_or(a: Self::Outcome, b: Self::Outcome) -> Self::Outcome;
    /// Where it does not hold.
    unsafe fn mask_not(a: Self::Outcome) -> Self::Outcome;
    /// In which lanes it holds, a bit for each.
    unsafe fn bits(a: Self::Outcome) -> u32;
    /// `then` where it holds, `otherwise` elsewhere.
    unsafe fn choose(
        mask: Self::Outcome,
        then: Self::Register,
        otherwise: Self::Register,
    ) -> Self::Register;
}

/// The numbers in one register of target `C`.
#[repr(transparent)]
pub struct Vector<F: Instructions<C>, C>(F::Register);

impl<F: Instructions<C>, C> Vector<F, C> {
    /// The numbers in their order.
    #[inline(always)]
    fn to_array(self) -> F::Array {
        let mut array = F::array(|_| F::default());
        // SAFETY: a vector exists only on a machine with the target's instructions; see above.
        unsafe { F::store(&mut array, self.0) };
        array
    }

    /// The vector of a function's values.
    #[inline(always)]
    fn from_fn(lane: impl FnMut(usize) -> F) -> Self {
        // SAFETY: the type can be named only on a machine with its instructions; see above.
        Vector(unsafe { F::load(&F::array(lane)) })
    }
}

impl<F: Instructions<C>, C> Clone for Vector<F, C> {
    #[inline(always)]
    fn clone(&self) -> Self {
        *self
    }
}

impl<F: Instructions<C>, C> Copy for Vector<F, C> {}

impl<F: Instructions<C>, C> fmt::Debug for Vector<F, C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Debug::fmt(self.to_array().as_ref(), f)
    }
}

impl<F: Instructions<C>, C> Default for Vector<F, C> {
    #[inline(always)]
    fn default() -> Self {
        Vector(F::ZEROS)
    }
}

/// Equality in every lane.
impl<F: Instructions<C>, C: 'static> PartialEq for Vector<F, C> {
    #[inline(always)]
    fn eq(&self, other: &Self) -> bool {
        let (low, high) = (self.is_at_most(*other), other.is_at_most(*self));
        <Self as ga_core::Lanes>::all(low & high)
    }
}

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

/// The outcome of a comparison of vectors.
pub struct Mask<F: Instructions<C>, C>(F::Outcome);

impl<F: Instructions<C>, C> Clone for Mask<F, C> {
    #[inline(always)]
    fn clone(&self) -> Self {
        *self
    }
}

impl<F: Instructions<C>, C> Copy for Mask<F, C> {}

impl<F: Instructions<C>, C> BitAnd for Mask<F, C> {
    type Output = Self;
    #[inline(always)]
    fn bitand(self, other: Self) -> Self {
        // SAFETY: masks come from vectors, which exist; see above.
        Mask(unsafe { F::mask_and(self.0, other.0) })
    }
}

impl<F: Instructions<C>, C> BitOr for Mask<F, C> {
    type Output = Self;
    #[inline(always)]
    fn bitor(self, other: Self) -> Self {
        // SAFETY: masks come from vectors, which exist; see above.
        Mask(unsafe { F::mask_or(self.0, other.0) })
    }
}

impl<F: Instructions<C>, C> Not for Mask<F, C> {
    type Output = Self;
    #[inline(always)]
    fn not(self) -> Self {
        // SAFETY: masks come from vectors, which exist; see above.
        Mask(unsafe { F::mask_not(self.0) })
    }
}

impl<F: Instructions<C>, C: 'static> ga_core::Lanes for Vector<F, C> {
    type Float = F;
    type Mask = Mask<F, C>;

    const PI: Self = Vector(F::PIS);
    const EPSILON: Self = Vector(F::EPSILONS);

    #[inline(always)]
    fn splat(value: F) -> Self {
        // SAFETY: the type can be named only on a machine with its instructions; see above.
        Vector(unsafe { F::same(value) })
    }

    #[inline(always)]
    fn map(self, function: impl Fn(F) -> F) -> Self {
        let array = self.to_array();
        Self::from_fn(|lane| function(array.as_ref()[lane]))
    }

    #[inline(always)]
    fn zip(self, other: Self, function: impl Fn(F, F) -> F) -> Self {
        let (own, other) = (self.to_array(), other.to_array());
        Self::from_fn(|lane| function(own.as_ref()[lane], other.as_ref()[lane]))
    }

    #[inline(always)]
    fn is_less(self, other: Self) -> Mask<F, C> {
        // SAFETY: two vectors exist; see above.
        Mask(unsafe { F::less(self.0, other.0) })
    }

    #[inline(always)]
    fn is_at_most(self, other: Self) -> Mask<F, C> {
        // SAFETY: two vectors exist; see above.
        Mask(unsafe { F::at_most(self.0, other.0) })
    }

    #[inline(always)]
    fn all(mask: Mask<F, C>) -> bool {
        // SAFETY: masks come from vectors, which exist; see above.
        unsafe { F::bits(mask.0) == u32::MAX >> (32 - F::COUNT) }
    }

    #[inline(always)]
    fn any(mask: Mask<F, C>) -> bool {
        // SAFETY: masks come from vectors, which exist; see above.
        unsafe { F::bits(mask.0) != 0 }
    }

    #[inline(always)]
    fn select(mask: Mask<F, C>, then: Self, otherwise: Self) -> Self {
        // SAFETY: two vectors exist; see above.
        Vector(unsafe { F::choose(mask.0, then.0, otherwise.0) })
    }

    #[inline(always)]
    fn magnitude(self) -> Self {
        // SAFETY: a vector exists; see above.
        Vector(unsafe { F::and(self.0, F::MAGNITUDES) })
    }

    #[inline(always)]
    fn with_sign_of(self, sign: Self) -> Self {
        // SAFETY: two vectors exist; see above.
        Vector(unsafe { F::or(self.magnitude().0, F::and(sign.0, F::SIGNS)) })
    }

    #[inline(always)]
    fn square_root(self) -> Self {
        // SAFETY: a vector exists; see above.
        Vector(unsafe { F::root(self.0) })
    }

    #[inline(always)]
    fn power_of_two(self) -> Self {
        // In this sum the exponent stands in the last bits.
        let biased = self + ga_core::Lanes::splat(F::ROUNDING + F::BIAS);
        // SAFETY: a vector exists; see above.
        Vector(unsafe { F::shift_up(biased.0) })
    }

    #[inline(always)]
    fn mantissa_and_exponent(self) -> (Self, Self) {
        let rounding: Self = ga_core::Lanes::splat(F::ROUNDING);
        // SAFETY: two vectors exist; see above.
        let (mantissa, shifted) = unsafe {
            (
                F::or(F::and(self.0, F::MANTISSAS), F::ONES),
                F::or(rounding.0, F::shift_down(self.0)),
            )
        };
        let biased: Self = ga_core::Lanes::splat(F::ROUNDING + F::BIAS);
        (Vector(mantissa), Vector(shifted) - biased)
    }
}

impl<F: Instructions<C>, C> sealed::Lanes for Vector<F, C> {}

impl<F: Instructions<C>, C: 'static> Lanes<F> for Vector<F, C> {
    const COUNT: usize = F::COUNT;
    type Array = F::Array;

    #[inline(always)]
    fn splat(value: F) -> Self {
        ga_core::Lanes::splat(value)
    }

    #[inline(always)]
    fn load(array: &F::Array) -> Self {
        // SAFETY: the type can be named only on a machine with its instructions; see above.
        Vector(unsafe { F::load(array) })
    }

    #[inline(always)]
    fn store(self, array: &mut F::Array) {
        // SAFETY: a vector exists; see above.
        unsafe { F::store(array, self.0) }
    }

    #[inline(always)]
    fn array(lane: impl FnMut(usize) -> F) -> F::Array {
        F::array(lane)
    }

    #[inline(always)]
    fn arrays(numbers: &[F]) -> &[F::Array] {
        F::arrays(numbers)
    }

    #[inline(always)]
    fn arrays_mut(numbers: &mut [F]) -> &mut [F::Array] {
        F::arrays_mut(numbers)
    }
}
