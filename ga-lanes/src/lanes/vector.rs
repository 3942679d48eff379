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
use core::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use ga_core::{Field, Narrowing, Real, Scalar};

use super::{Lanes, sealed};

/// The instructions of target `C` for numbers of this type.
///
/// # Safety
/// Every function may be called only on a machine that has the target's instructions.
pub trait Instructions<C>: Real {
    /// A vector register.
    type Register: Copy + 'static;
    /// The numbers of a register in memory.
    type Array: Copy + AsRef<[Self]> + AsMut<[Self]>;
    /// How many numbers a register holds.
    const COUNT: usize;
    /// 0 in every lane.
    const ZEROS: Self::Register;
    /// 1 in every lane.
    const ONES: Self::Register;
    /// π in every lane.
    const PIS: Self::Register;
    /// The rounding of 1 in every lane.
    const EPSILONS: Self::Register;

    /// The arrays of a slice.
    fn arrays(numbers: &[Self]) -> &[Self::Array];
    /// The arrays of a slice, to be written.
    fn arrays_mut(numbers: &mut [Self]) -> &mut [Self::Array];
    /// The array of a function's values.
    fn array(lane: impl FnMut(usize) -> Self) -> Self::Array;
    /// One number in every lane.
    unsafe fn splat(value: Self) -> Self::Register;
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
    /// −a
    unsafe fn negative(a: Self::Register) -> Self::Register;
    /// |a|
    unsafe fn magnitude(a: Self::Register) -> Self::Register;
    /// √a
    unsafe fn root(a: Self::Register) -> Self::Register;
    /// `then` where a ≤ b, `otherwise` elsewhere
    unsafe fn choose_le(
        a: Self::Register,
        b: Self::Register,
        then: Self::Register,
        otherwise: Self::Register,
    ) -> Self::Register;
    /// Whether a ≤ b in every lane.
    unsafe fn are_le(a: Self::Register, b: Self::Register) -> bool;
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

    /// A function of every lane, one after the other.
    #[inline(always)]
    fn map(self, mut function: impl FnMut(F) -> F) -> Self {
        let array = self.to_array();
        Self::from_fn(|lane| function(array.as_ref()[lane]))
    }

    /// Two functions of every lane, one after the other.
    #[inline(always)]
    fn map_pair(self, function: impl Fn(F) -> (F, F)) -> (Self, Self) {
        let mut second = F::array(|_| F::default());
        let array = self.to_array();
        let first = Self::from_fn(|lane| {
            let (first, other) = function(array.as_ref()[lane]);
            second.as_mut()[lane] = other;
            first
        });
        // SAFETY: the vector `first` exists; see above.
        (first, Vector(unsafe { F::load(&second) }))
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
impl<F: Instructions<C>, C> PartialEq for Vector<F, C> {
    #[inline(always)]
    fn eq(&self, other: &Self) -> bool {
        // SAFETY: two vectors exist; see above.
        unsafe { F::are_le(self.0, other.0) && F::are_le(other.0, self.0) }
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
        Vector(unsafe { F::negative(self.0) })
    }
}

impl<F: Instructions<C>, C: 'static> Scalar for Vector<F, C> {
    const ZERO: Self = Vector(F::ZEROS);
    const ONE: Self = Vector(F::ONES);

    #[inline(always)]
    fn from_integer(n: i64) -> Self {
        Self::splat(F::from_integer(n))
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
        Self::splat(F::from_ratio(numerator, denominator))
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

/// Roots, comparisons and absolute values act on all lanes at once; the other functions run lane
/// by lane, so that a lane at the edge of a domain leaves the others alone.
impl<F: Instructions<C>, C: 'static> Real for Vector<F, C> {
    const PI: Self = Vector(F::PIS);
    const EPSILON: Self = Vector(F::EPSILONS);

    #[inline(always)]
    fn from_f64(value: f64) -> Self {
        Self::splat(F::from_f64(value))
    }

    #[inline(always)]
    fn at_value(self, value: Self) -> Self {
        value
    }

    #[inline(always)]
    fn abs(self) -> Self {
        // SAFETY: a vector exists; see above.
        Vector(unsafe { F::magnitude(self.0) })
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        // SAFETY: a vector exists; see above.
        Vector(unsafe { F::root(self.0) })
    }

    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        self.map_pair(F::sin_cos)
    }

    #[inline(always)]
    fn atan2(self, x: Self) -> Self {
        let (y, x) = (self.to_array(), x.to_array());
        Self::from_fn(|lane| y.as_ref()[lane].atan2(x.as_ref()[lane]))
    }

    #[inline(always)]
    fn exp(self) -> Self {
        self.map(F::exp)
    }

    #[inline(always)]
    fn ln(self) -> Self {
        self.map(F::ln)
    }

    #[inline(always)]
    fn cosh_sinhc(self) -> (Self, Self) {
        self.map_pair(F::cosh_sinhc)
    }

    #[inline(always)]
    fn log_factor(self, square: Self) -> Option<Self> {
        let (mut factors, squares) = (self.to_array(), square.to_array());
        for (factor, square) in factors.as_mut().iter_mut().zip(squares.as_ref()) {
            *factor = factor.log_factor(*square)?;
        }
        Some(Self::load(&factors))
    }

    #[inline(always)]
    fn is_finite(self) -> bool {
        // The difference with itself is not a number in lanes that are not finite.
        Real::abs(self - self).all_le(Self::ZERO)
    }

    #[inline(always)]
    fn all_le(self, other: Self) -> bool {
        // SAFETY: two vectors exist; see above.
        unsafe { F::are_le(self.0, other.0) }
    }

    #[inline(always)]
    fn select_le(self, bound: Self, then: Self, otherwise: Self) -> Self {
        // SAFETY: four vectors exist; see above.
        Vector(unsafe { F::choose_le(self.0, bound.0, then.0, otherwise.0) })
    }
}

impl<F: Instructions<C>, C> sealed::Lanes for Vector<F, C> {}

impl<F: Instructions<C>, C: 'static> Lanes<F> for Vector<F, C> {
    const COUNT: usize = F::COUNT;
    type Array = F::Array;

    #[inline(always)]
    fn splat(value: F) -> Self {
        // SAFETY: the type can be named only on a machine with its instructions; see above.
        Vector(unsafe { F::splat(value) })
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
