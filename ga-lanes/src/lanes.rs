//! What a kernel may ask of lanes: to be loaded, stored, broadcast and counted.

#[cfg(target_arch = "x86_64")]
pub(crate) mod instructions;
mod portable;
#[cfg(target_arch = "x86_64")]
pub(crate) mod vector;
#[cfg(target_arch = "x86_64")]
mod x86;

use ga_core::Real;

/// Several numbers that undergo the same operations: the scalar of a kernel.
///
/// How many they are and in which registers they stand is decided at run time; see
/// [`dispatch`](crate::dispatch). The trait is sealed: its types are those of this crate.
pub trait Lanes<F: Copy>: Real + sealed::Lanes {
    /// How many numbers there are.
    const COUNT: usize;
    /// The numbers in their order, as they stand in memory.
    type Array: Copy + AsRef<[F]> + AsMut<[F]>;

    /// The same number in every lane.
    fn splat(value: F) -> Self;
    /// The numbers of an array.
    fn load(array: &Self::Array) -> Self;
    /// Writes the numbers to an array.
    fn store(self, array: &mut Self::Array);
    /// The array of the numbers that a function gives for each lane.
    fn array(lane: impl FnMut(usize) -> F) -> Self::Array;
    /// The whole arrays at the beginning of a slice.
    fn arrays(numbers: &[F]) -> &[Self::Array];
    /// The whole arrays at the beginning of a slice, to be written.
    fn arrays_mut(numbers: &mut [F]) -> &mut [Self::Array];
}

pub(crate) mod sealed {
    /// Keeps foreign types out of [`Lanes`](super::Lanes).
    pub trait Lanes {}
}
