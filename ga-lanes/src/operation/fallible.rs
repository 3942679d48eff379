//! Operations that some elements have no value of.

use ga_core::{Element, Field, Real, Scalar, ops};

use crate::number::Number;
#[cfg(target_arch = "x86_64")]
use crate::number::{Wide, Widest};

/// The type of the values of an attempt.
pub trait Attempt<X> {
    /// The type.
    type Output: Element;
    /// Whether it is too long to be inlined into the function of a target.
    const LONG: bool = false;
}

/// An attempt in lanes `L`: the values, where all lanes have one.
pub trait AttemptIn<X: Element, L: Scalar>: Attempt<X> {
    /// The values.
    fn call(&self, x: X::Over<L>) -> Option<<Self::Output as Element>::Over<L>>;
}

/// An attempt that exists for the lanes of every target.
#[cfg(target_arch = "x86_64")]
#[diagnostic::on_unimplemented(
    message = "this batch has no such operation",
    label = "not generated for the type of the elements"
)]
pub trait AttemptEverywhere<X: Element, F: Number>:
    Attempt<X, Output: Element<Number = F>>
    + AttemptIn<X, F::Portable>
    + AttemptIn<X, Wide<F>>
    + AttemptIn<X, Widest<F>>
    + Sync
{
}
#[cfg(target_arch = "x86_64")]
impl<X: Element, F: Number, O> AttemptEverywhere<X, F> for O where
    O: Attempt<X, Output: Element<Number = F>>
        + AttemptIn<X, F::Portable>
        + AttemptIn<X, Wide<F>>
        + AttemptIn<X, Widest<F>>
        + Sync
{
}

/// An attempt that exists for the lanes of every target.
#[cfg(not(target_arch = "x86_64"))]
pub trait AttemptEverywhere<X: Element, F: Number>:
    Attempt<X, Output: Element<Number = F>> + AttemptIn<X, F::Portable> + Sync
{
}
#[cfg(not(target_arch = "x86_64"))]
impl<X: Element, F: Number, O> AttemptEverywhere<X, F> for O where
    O: Attempt<X, Output: Element<Number = F>> + AttemptIn<X, F::Portable> + Sync
{
}

macro_rules! attempts {
    ($($name:ident: $trait:ident $method:ident $(, $long:ident)?;)*) => {$(
        #[doc = concat!("The operation `", stringify!($method), "`.")]
        pub struct $name;

        impl<X: ops::$trait<Output: Element>> Attempt<X> for $name {
            type Output = X::Output;
            $(const LONG: bool = X::$long;)?
        }

        impl<X, L> AttemptIn<X, L> for $name
        where
            X: Element + ops::$trait<Output: Element>,
            L: Scalar,
            X::Over<L>: ops::$trait<Output = <<X as ops::$trait>::Output as Element>::Over<L>>,
        {
            #[inline(always)]
            fn call(&self, x: X::Over<L>) -> Option<<Self::Output as Element>::Over<L>> {
                ops::$trait::$method(x)
            }
        }
    )*};
}

attempts! {
    Logarithm: Logarithm log, LONG;
    SquareRoot: SquareRoot sqrt, LONG;
    Renormalize: Renormalize renormalized;
}

/// The multiplicative inverse.
pub struct Inverse;

impl<X: Element + ops::Inverse<Output: Element>> Attempt<X> for Inverse {
    type Output = X::Output;
    const LONG: bool = X::LONG;
}

impl<X, L> AttemptIn<X, L> for Inverse
where
    X: Element + ops::Inverse<Output: Element>,
    L: Field,
    X::Over<L>: ops::Inverse<Output = <<X as ops::Inverse>::Output as Element>::Over<L>>,
{
    #[inline(always)]
    fn call(&self, x: X::Over<L>) -> Option<<Self::Output as Element>::Over<L>> {
        ops::Inverse::inverse(x)
    }
}

/// The element over its norm.
pub struct Normalized;

/// `x` over its norm, in every lane or not at all.
#[inline(always)]
fn over_norm<X, T>(x: X) -> Option<<X as ops::Geometric<T>>::Output>
where
    T: Real,
    X: Copy + ops::NormSquared<Output = T> + ops::Geometric<T>,
{
    let norm = ops::norm(x);
    (norm.is_invertible() && norm.is_finite()).then(|| x.geometric(T::ONE / norm))
}

impl<X> Attempt<X> for Normalized
where
    X: Element<Number: Real>
        + ops::NormSquared<Output = X::Number>
        + ops::Geometric<X::Number, Output: Element>,
{
    type Output = <X as ops::Geometric<X::Number>>::Output;
}

impl<X, L> AttemptIn<X, L> for Normalized
where
    X: Element<Number: Real>
        + ops::NormSquared<Output = X::Number>
        + ops::Geometric<X::Number, Output: Element>,
    L: Real,
    X::Over<L>: ops::NormSquared<Output = L>
        + ops::Geometric<L, Output = <<X as ops::Geometric<X::Number>>::Output as Element>::Over<L>>,
{
    #[inline(always)]
    fn call(&self, x: X::Over<L>) -> Option<<Self::Output as Element>::Over<L>> {
        over_norm(x)
    }
}
