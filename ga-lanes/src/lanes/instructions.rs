//! What the lanes of a target are made of: its registers, and an instruction for each operation.

use ga_core::{Computation, Precision};

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
    /// ½ in every lane.
    const HALVES: Self::Register;
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
    /// A computation in a function of its own that has the instructions of the target.
    unsafe fn outlined<K: Computation>(computation: K) -> K::Output;
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
