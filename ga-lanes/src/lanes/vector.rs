//! Numbers in one vector register: the ring, field and real operations by the instructions of a
//! target.
//!
//! # Safety
//! The operators are safe to call, as the traits of ga-core want them, and execute instructions
//! that a machine may lack. They are sound because a [`Vector`] cannot be had, nor its type be
//! named, outside a kernel: this module is private, no public item has the type as an associated
//! one, and [`dispatch`](crate::dispatch) runs kernels only on targets that the machine was found
//! to have. What a kernel smuggles out in a box stays on that machine.

mod functions;
mod mask;
mod numbers;

use core::fmt;
use ga_core::Lanes as _;

use super::instructions::Instructions;
use mask::Mask;

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
