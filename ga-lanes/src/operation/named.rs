//! The operations of generated types, by name.

use ga_core::{Element, Field, Real, Scalar, ops};

use super::{Operation, Values};

macro_rules! binary {
    ($($name:ident: $trait:ident $method:ident from $($path:ident)::*;)*) => {$(
        #[doc = concat!("The operation `", stringify!($method), "`.")]
        pub struct $name;

        impl<X, Y> Values<X, Y> for $name
        where
            X: $($path)::*::$trait<Y, Output: Element>,
        {
            type Output = X::Output;
        }

        impl<X, Y, L> Operation<X, Y, L> for $name
        where
            X: Element + $($path)::*::$trait<Y, Output: Element>,
            Y: Element,
            L: Scalar,
            X::Over<L>: $($path)::*::$trait<
                Y::Over<L>,
                Output = <<X as $($path)::*::$trait<Y>>::Output as Element>::Over<L>,
            >,
        {
            type Left = X::Over<L>;

            #[inline(always)]
            fn left(x: X::Over<L>) -> X::Over<L> {
                x
            }

            #[inline(always)]
            fn call(&self, x: X::Over<L>, y: Y::Over<L>) -> <Self::Output as Element>::Over<L> {
                $($path)::*::$trait::$method(x, y)
            }
        }
    )*};
}

binary! {
    Geometric: Geometric geometric from ops;
    Wedge: Wedge wedge from ops;
    LeftContract: LeftContract left_contract from ops;
    RightContract: RightContract right_contract from ops;
    Inner: Inner inner from ops;
    ScalarProduct: ScalarProduct scalar_product from ops;
    Regressive: Regressive regressive from ops;
    Commutator: Commutator commutator from ops;
    Anticommutator: Anticommutator anticommutator from ops;
    Quotient: Quotient quotient from ops;
    Sandwich: Sandwich sandwich from ops;
    Apply: Apply apply from ops;
    Plus: Add add from core::ops;
    Minus: Sub sub from core::ops;
}

macro_rules! unary {
    ($($name:ident: $trait:ident $method:ident from $($path:ident)::* $(, $long:ident)?;)*) => {$(
        #[doc = concat!("The operation `", stringify!($method), "`.")]
        pub struct $name;

        impl<X> Values<X::Number, X> for $name
        where
            X: Element + $($path)::*::$trait<Output: Element>,
        {
            type Output = X::Output;
            $(const LONG: bool = <X as ops::$trait>::$long;)?
        }

        impl<X, L> Operation<X::Number, X, L> for $name
        where
            X: Element + $($path)::*::$trait<Output: Element>,
            L: Scalar,
            X::Over<L>: $($path)::*::$trait<
                Output = <<X as $($path)::*::$trait>::Output as Element>::Over<L>,
            >,
        {
            type Left = L;

            #[inline(always)]
            fn left(x: L) -> L {
                x
            }

            #[inline(always)]
            fn call(&self, _: L, x: X::Over<L>) -> <Self::Output as Element>::Over<L> {
                $($path)::*::$trait::$method(x)
            }
        }
    )*};
}

unary! {
    Reverse: Reverse reverse from ops;
    Involute: Involute involute from ops;
    Conjugate: Conjugate conjugate from ops;
    Dual: Dual dual from ops;
    Undual: Undual undual from ops;
    LeftComplement: LeftComplement left_complement from ops;
    RightComplement: RightComplement right_complement from ops;
    NormSquared: NormSquared norm_squared from ops;
    Exponential: Exponential exp from ops, LONG;
    Opposite: Neg neg from core::ops;
}

/// The norm `√|⟨X X̃⟩|`.
pub struct Norm;

impl<X: Element + ops::NormSquared<Output = X::Number>> Values<X::Number, X> for Norm {
    type Output = X::Number;
}

impl<X, L> Operation<X::Number, X, L> for Norm
where
    X: Element + ops::NormSquared<Output = X::Number>,
    L: Real,
    X::Over<L>: ops::NormSquared<Output = L>,
{
    type Left = L;

    #[inline(always)]
    fn left(x: L) -> L {
        x
    }

    #[inline(always)]
    fn call(&self, _: L, x: X::Over<L>) -> L {
        ops::norm(x)
    }
}

macro_rules! one_on_many {
    (
        $(#[$doc:meta])*
        $name:ident keeps $Left:ty:
        |$versor:ident| $left:expr, |$kept:ident, $operand:ident| $image:expr
    ) => {
        $(#[$doc])*
        pub struct $name;

        impl<X, Y> Values<X, Y> for $name
        where
            X: ops::Outermorphism<Y, Image: Element>,
        {
            type Output = X::Image;
        }

        impl<X, Y, L> Operation<X, Y, L> for $name
        where
            X: Element + ops::Outermorphism<Y, Image: Element>,
            Y: Element,
            L: Field,
            X::Over<L>: ops::Versor<Number = L>
                + ops::Outermorphism<Y::Over<L>, Image = <X::Image as Element>::Over<L>>,
        {
            type Left = $Left;

            #[inline(always)]
            fn left($versor: X::Over<L>) -> Self::Left {
                $left
            }

            #[inline(always)]
            fn call(
                &self,
                $kept: Self::Left,
                $operand: Y::Over<L>,
            ) -> <Self::Output as Element>::Over<L> {
                $image
            }
        }
    };
}

one_on_many! {
    /// Versor application by the matrix of the versor.
    ByMatrix keeps <X::Over<L> as ops::Outermorphism<Y::Over<L>>>::Rows:
    |versor| ops::Outermorphism::rows_with(versor, ops::Versor::over_norm(versor)),
    |rows, y| <X::Over<L> as ops::Outermorphism<Y::Over<L>>>::image(&rows, y)
}

one_on_many! {
    /// Versor application by the versor and the multiple whose reverse is its inverse.
    ByVersor keeps (X::Over<L>, <X::Over<L> as ops::Versor>::Multiple):
    |versor| (versor, ops::Versor::over_norm(versor)),
    |kept, y| ops::ApplyUnit::apply_with(kept.0, kept.1, y)
}
