//! The traits that generated types implement and that generic code is written against.
//!
//! ```
//! use ga_core::ops::{Geometric, Wedge};
//!
//! /// The area spanned by two elements, whatever algebra they are from.
//! fn span<A: Wedge<B>, B>(a: A, b: B) -> A::Output {
//!     a.wedge(b)
//! }
//! ```

mod application;

pub use application::{Apply, ApplyUnit, Outermorphism, Sandwich, Versor};

use core::ops::{Add, Sub};

use crate::algorithm::Split;
use crate::{Blade, Field, Real, Scalar};

/// A blade, and a quadratic form in the stored coefficients of a type: terms of two positions and
/// a factor, numerator and denominator. The position after the last stands for 1.
pub type VanishingForm = (Blade, &'static [(usize, usize, i64, i64)]);

/// A generated type: a list of coefficients, each belonging to a signed basis blade.
pub trait Element: Copy + PartialEq {
    /// The type of the coefficients.
    type Number: Scalar;

    /// The same type over other numbers: what [`Number`](Element::Number) is replaced by.
    type Over<U: Scalar>: Element<Number = U>;

    /// The blades of the stored coefficients in their order, as bitmask and the sign that the
    /// spelling has against the increasing order (−1 for `e31`).
    const BLADES: &'static [(Blade, i8)];
    /// The blades whose coefficients are fixed, with sign, numerator and denominator.
    const FIXED: &'static [(Blade, i8, i64, i64)];
    /// The labels of the stored coefficients, `1` for the scalar.
    const LABELS: &'static [&'static str];

    /// The square of a type declared `#[null]`, by blade: what vanishes for all of its values.
    const NULL: &'static [VanishingForm] = &[];

    /// The stored coefficient at a position of [`BLADES`](Element::BLADES); zero beyond.
    fn at(&self, position: usize) -> Self::Number;

    /// The element whose stored coefficient at each position is given by a function.
    fn from_fn(coefficient: impl FnMut(usize) -> Self::Number) -> Self;

    /// Where the coefficient at a position is stored; `None` beyond the last, and for types that
    /// do not store what [`at`](Element::at) gives.
    #[inline]
    fn place(&self, _position: usize) -> Option<&Self::Number> {
        None
    }

    /// Where the coefficient at a position is stored, to be written; `None` as for
    /// [`place`](Element::place).
    #[inline]
    fn place_mut(&mut self, _position: usize) -> Option<&mut Self::Number> {
        None
    }

    /// The stored coefficient of a blade in the increasing order of its vectors; zero for a
    /// blade that the type does not store.
    #[inline]
    fn coefficient(&self, blade: Blade) -> Self::Number {
        match Self::BLADES.iter().position(|(stored, _)| *stored == blade) {
            Some(position) if Self::BLADES[position].1 < 0 => -self.at(position),
            Some(position) => self.at(position),
            None => Self::Number::ZERO,
        }
    }
}

/// A number is an element too: a scalar, its own only coefficient.
impl<T: Scalar> Element for T {
    type Number = T;
    type Over<U: Scalar> = U;
    const BLADES: &'static [(Blade, i8)] = &[(Blade::SCALAR, 1)];
    const FIXED: &'static [(Blade, i8, i64, i64)] = &[];
    const LABELS: &'static [&'static str] = &["1"];

    #[inline(always)]
    fn at(&self, position: usize) -> T {
        if position == 0 { *self } else { T::ZERO }
    }

    #[inline(always)]
    fn from_fn(mut coefficient: impl FnMut(usize) -> T) -> T {
        coefficient(0)
    }

    #[inline(always)]
    fn place(&self, position: usize) -> Option<&T> {
        (position == 0).then_some(self)
    }

    #[inline(always)]
    fn place_mut(&mut self, position: usize) -> Option<&mut T> {
        (position == 0).then_some(self)
    }
}

macro_rules! products {
    ($($(#[$doc:meta])* $name:ident $method:ident)*) => {$(
        $(#[$doc])*
        #[diagnostic::on_unimplemented(
            message = "no declared type holds the `{Self}`–`{B}` product of this name",
            label = "this product is not generated",
            note = "declare a type that holds the result, or list the product in `products {{ … }}`"
        )]
        pub trait $name<B = Self> {
            /// The smallest declared type that holds the result.
            type Output;
            /// The product of `self` and `b`.
            fn $method(self, b: B) -> Self::Output;
        }
    )*};
}

products! {
    /// The geometric product `a b`, operator `*`; also the product with a number.
    Geometric geometric
    /// The outer product `a ∧ b`, operator `^`.
    Wedge wedge
    /// The left contraction `a ⌋ b`, operator `<<`.
    LeftContract left_contract
    /// The right contraction `a ⌊ b`.
    RightContract right_contract
    /// The inner product `a · b` of (2.71), operator `|`.
    Inner inner
    /// The scalar product `⟨a b⟩`.
    ScalarProduct scalar_product
    /// The regressive product `a ∨ b`, operator `&`.
    Regressive regressive
    /// The commutator product `(ab − ba)/2`.
    Commutator commutator
    /// The anticommutator product `(ab + ba)/2`.
    Anticommutator anticommutator
    /// Division, operator `/`: `a b⁻¹`; non-finite where `b` has no inverse, as in floats.
    Quotient quotient
}

/// The geometric product term by term, of types whose [`Geometric`] product goes through matrices
/// ([`matrix`](crate::matrix)) where numbers round: slower, but what vanishes in every term is
/// exactly zero, and an infinity or a NaN spoils only what it takes part in.
pub trait TermByTerm<B = Self> {
    /// The type of the geometric product.
    type Output;
    /// The product `self b`.
    fn term_by_term(self, b: B) -> Self::Output;
}

/// An element that can be added to those of another type `B`, and subtracted: operators `+` and
/// `-`.
pub trait Addend<B>: Sized {
    /// The smallest declared type that holds both.
    type Sum: From<Self> + From<B> + Add<Output = Self::Sum> + Sub<Output = Self::Sum>;
}

macro_rules! maps {
    ($($(#[$doc:meta])* $name:ident $method:ident)*) => {$(
        $(#[$doc])*
        pub trait $name {
            /// The smallest declared type that holds the result.
            type Output;
            /// See the trait.
            fn $method(self) -> Self::Output;
        }
    )*};
}

maps! {
    /// The reverse: factors in opposite order, sign (−1)^{k(k−1)/2} on grade k.
    Reverse reverse
    /// The grade involution: sign (−1)^k on grade k.
    Involute involute
    /// The Clifford conjugate: sign (−1)^{k(k+1)/2} on grade k.
    Conjugate conjugate
    /// The dual `A I⁻¹`, operator `!`; only where the pseudoscalar is invertible.
    #[diagnostic::on_unimplemented(
        message = "`{Self}` has no dual",
        label = "not generated",
        note = "the metric is degenerate, where only the complements exist, or no declared type holds the dual"
    )]
    Dual dual
    /// The inverse of the dual, `A I`.
    Undual undual
    /// The left complement: `left_complement(e) ∧ e = I`, without use of the metric.
    LeftComplement left_complement
    /// The right complement: `e ∧ right_complement(e) = I`, without use of the metric.
    RightComplement right_complement
    /// The squared norm `⟨X X̃⟩` with its sign.
    NormSquared norm_squared
}

/// Exponentials.
pub trait Exponential {
    /// The smallest declared type that holds the result.
    type Output;
    /// Whether the computation is so long that lanes do not inline it: batches then run it in the
    /// lanes of every machine.
    #[doc(hidden)]
    const LONG: bool = false;
    /// The exponential.
    fn exp(self) -> Self::Output;
}

/// Multiplicative inverses.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no generated inverse",
    label = "not generated",
    note = "no declared type holds the inverse; above eight dimensions only elements whose `X X̃` is always a scalar have one, and `ga_core::dense` inverts any element at run time"
)]
pub trait Inverse: Sized {
    /// The type of the coefficients.
    type Number: Field;
    /// The type of the inverse.
    type Output: Copy;
    /// Whether the computation is so long that lanes do not inline it: batches then run it in the
    /// lanes of every machine.
    #[doc(hidden)]
    const LONG: bool = false;
    /// The number that the adjugate is divided by; zero where there is no inverse.
    fn determinant(self) -> Self::Number;
    /// The inverse times the determinant.
    fn adjugate(self) -> Self::Output;
    /// The adjugate times a number.
    fn scale(adjugate: Self::Output, factor: Self::Number) -> Self::Output;

    /// The inverse, if there is one.
    #[inline(always)]
    fn inverse(self) -> Option<Self::Output>
    where
        Self: Copy,
    {
        let determinant = self.determinant();
        if !determinant.is_invertible() {
            return None;
        }
        let factor = <Self::Number as Scalar>::ONE / determinant;
        Some(Self::scale(self.adjugate(), factor))
    }

    /// The inverse without the question whether it exists; non-finite where it does not.
    #[inline(always)]
    fn reciprocal(self) -> Self::Output
    where
        Self: Copy,
    {
        let factor = <Self::Number as Scalar>::ONE / self.determinant();
        Self::scale(self.adjugate(), factor)
    }
}

/// Logarithms of versors.
///
/// The logarithm of a ratio, `(v2 / v1).log()`, generates the motion that takes one versor to the
/// other: `(step * t).exp() * v1` leads from the first at t = 0 to the second at t = 1.
pub trait Logarithm {
    /// The type of the generator.
    type Output;
    /// Whether the computation is so long that lanes do not inline it: batches then run it in the
    /// lanes of every machine.
    #[doc(hidden)]
    const LONG: bool = false;
    /// The principal logarithm of the versor over its norm; `None` where there is no real one
    /// or it is not unique, and for what is no versor.
    fn log(self) -> Option<Self::Output>;
    /// The principal logarithm of a versor that is promised to be a unit one, which spares asking
    /// for its norm. Of another one it is not the logarithm; but no panic.
    fn log_of_unit(self) -> Option<Self::Output>
    where
        Self: Sized,
    {
        self.log()
    }
}

/// Square roots of versors.
pub trait SquareRoot: Sized {
    /// The type of the root.
    type Output;
    /// Whether the computation is so long that lanes do not inline it: batches then run it in the
    /// lanes of every machine.
    #[doc(hidden)]
    const LONG: bool = false;
    /// The principal square root; `None` where there is no real one or it is not unique, and
    /// for what is no versor.
    fn sqrt(self) -> Option<Self::Output>;
}

/// Polar normalisation of even elements.
pub trait Renormalize {
    /// The type of the versor.
    type Output;
    /// The unit versor `(X X̃)^(−1/2) X`, nearest to a versor that rounding has moved; `None`
    /// where X X̃ has no inverse square root, or no positive scalar part.
    ///
    /// The factor stands on the left: in five dimensions X X̃ need not commute with X, and
    /// `X (X X̃)^(−1/2)` is then no versor.
    fn renormalized(self) -> Option<Self::Output>;
}

/// The split of bivectors into commuting blades (5.5, 5.12).
pub trait SplitCommuting {
    /// The type of the blades.
    type Output;
    /// Two blades that commute and whose sum is the bivector, where they are unique.
    fn split_commuting(self) -> Split<Self::Output>;
}

/// The norm `√|⟨X X̃⟩|`.
#[inline]
pub fn norm<X: NormSquared>(x: X) -> X::Output
where
    X::Output: Real,
{
    x.norm_squared().abs().sqrt()
}
