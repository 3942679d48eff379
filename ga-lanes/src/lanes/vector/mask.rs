//! Comparisons of vectors, lane by lane.

use core::ops::{BitAnd, BitOr, Not};

use super::Instructions;

/// The outcome of a comparison of vectors.
pub struct Mask<F: Instructions<C>, C>(pub(super) F::Outcome);

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
