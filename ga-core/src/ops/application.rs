//! What versors do to other elements, with and without the promise of being unit.

use crate::{Field, Real, Scalar};

/// The sandwich `V x̂ Ṽ`: (2.28) times the squared norm of `V`, by ring operations alone.
pub trait Sandwich<X> {
    /// The type of the result, the operand's own where that holds it.
    type Output;
    /// `V x̂ Ṽ`, with the grade involution of `x` for odd `V`.
    fn sandwich(self, x: X) -> Self::Output;
}

/// Versor application `V x̂ V⁻¹` (2.28), written R\[X\] in the dissertation.
///
/// Formula and operation counts stand with the implementation of [`ApplyUnit`] for the two types.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no versor for `{X}`",
    note = "versors are types of even blades only or of odd blades only"
)]
pub trait Apply<X> {
    /// The type of the result, the operand's own where that holds it.
    type Output;
    /// The image of `x` under the versor.
    fn apply(self, x: X) -> Self::Output;
}

/// A type of versors: of even blades only or of odd blades only, and not of null elements only.
pub trait Versor: Copy {
    /// The type of the coefficients.
    type Number: Scalar;
    /// The type of the multiples of these versors: their own, or one without the fixed
    /// coefficients.
    type Multiple: Copy;

    /// The versor as a multiple of itself.
    fn multiple(self) -> Self::Multiple;

    /// `V/⟨V Ṽ⟩`, the reverse of `V⁻¹`; the versor itself where its type promises `V Ṽ = 1`.
    fn over_norm(self) -> Self::Multiple
    where
        Self::Number: Field;

    /// The positive multiple with `⟨V Ṽ⟩ = 1`; `None` where `⟨V Ṽ⟩` is not a positive number.
    fn unit(self) -> Option<Self::Multiple>
    where
        Self::Number: Real;
}

/// Versor application where the inverse is known: what [`Apply`] and
/// [`Unit::apply`](crate::Unit::apply) have in common.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is no versor for `{X}`",
    note = "versors are types of even blades only or of odd blades only"
)]
pub trait ApplyUnit<X>: Versor {
    /// The type of the result, the operand's own where that holds it.
    type Image;

    /// `V x̂ W̃ = x + (V x̂ − x V) W̃`, given the multiple `W` of `V` whose reverse is `V⁻¹`.
    fn apply_with(self, w: Self::Multiple, x: X) -> Self::Image;

    /// `V x̂ Ṽ` of a versor that is unit: the same with `W = V`.
    #[inline(always)]
    fn apply_unit(self, x: X) -> Self::Image {
        self.apply_with(self.multiple(), x)
    }

    /// `V x̂ V⁻¹` of any versor: the same with `W = V/⟨V Ṽ⟩`.
    #[inline(always)]
    fn apply_divided(self, x: X) -> Self::Image
    where
        Self::Number: Field,
    {
        self.apply_with(self.over_norm(), x)
    }
}

/// Versor application as a matrix, whose pattern of entries is known for the two types: what
/// [`LinearMap`](crate::LinearMap) is made of.
#[diagnostic::on_unimplemented(
    message = "no matrix of `{Self}` on `{X}` is generated",
    note = "matrices exist where the application has a body of its own; `apply` is there for the others"
)]
pub trait Outermorphism<X>: ApplyUnit<X> {
    /// The entries that are stored: an array for each coefficient of the result.
    type Rows: Copy;

    /// From how many elements on the matrix costs fewer multiplications than applications one by
    /// one, the building included; `None` where it never does.
    const WORTHWHILE: Option<usize>;

    /// The entries, given the multiple `W` of the versor whose reverse is the inverse.
    fn rows_with(self, w: Self::Multiple) -> Self::Rows;

    /// The matrix times the coefficients of an element.
    fn image(rows: &Self::Rows, x: X) -> Self::Image;
}
