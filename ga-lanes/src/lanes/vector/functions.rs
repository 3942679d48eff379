//! What real functions ask of vectors, and how kernels load and store them.

use ga_core::Computation;

use super::{Instructions, Mask, Vector};
use crate::lanes::{Lanes, sealed};

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

    #[inline(always)]
    fn outlined<K: Computation>(computation: K) -> K::Output {
        // SAFETY: the type can be named only on a machine with its instructions; see above.
        unsafe { <F as Instructions<C>>::outlined(computation) }
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
