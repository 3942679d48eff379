//! What two types have in common: their sums in a wider type, and the way back to the narrower one.

/// The types of the sums of different types.
#[doc(hidden)]
#[macro_export]
macro_rules! sums {
    ($bound:ident $Left:ident: $($Right:ident => $Sum:ident),*) => {$(
        impl<T: $crate::$bound> $crate::ops::Addend<$Right<T>> for $Left<T> {
            type Sum = $Sum<T>;
        }
    )*};
}

/// Narrowing conversions, the inverses of the widening ones.
#[doc(hidden)]
#[macro_export]
macro_rules! narrowing {
    ($Name:ident: $($Wide:ident),*) => {$(
        impl<T: $crate::Field> ::core::convert::TryFrom<$Wide<T>> for $Name<T> {
            type Error = $crate::Narrowing;
            $crate::inlined! {
                /// The coefficients that the type stores, each as it is; an error where one of the
                /// others is not negligible against the largest, or not zero in exact numbers. No
                /// operations apart from the comparison: two multiplications and four additions a
                /// coefficient at most.
                fn try_from(wide: $Wide<T>) -> ::core::result::Result<Self, $crate::Narrowing> {
                    $crate::convert::try_narrow(wide)
                }
            }
        }
    )*};
}
