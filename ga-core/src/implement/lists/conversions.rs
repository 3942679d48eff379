//! What two types have in common: their sums in a wider type, and the way back to the narrower one.

/// Sums and differences of different types, in the smallest type that holds both.
#[doc(hidden)]
#[macro_export]
macro_rules! sums {
    ($bound:ident $Left:ident: $($Right:ident => $Sum:ident),*) => {$(
        impl<T: $crate::$bound> ::core::ops::Add<$Right<T>> for $Left<T> {
            type Output = $Sum<T>;
            $crate::inlined! {
                /// The sum, in the smallest type that holds both; one addition a coefficient.
                fn add(self, b: $Right<T>) -> $Sum<T> {
                    $Sum::from(self) + $Sum::from(b)
                }
            }
        }
        impl<T: $crate::$bound> ::core::ops::Sub<$Right<T>> for $Left<T> {
            type Output = $Sum<T>;
            $crate::inlined! {
                /// The difference, in the smallest type that holds both; one subtraction a
                /// coefficient.
                fn sub(self, b: $Right<T>) -> $Sum<T> {
                    $Sum::from(self) - $Sum::from(b)
                }
            }
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
