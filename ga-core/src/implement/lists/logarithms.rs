//! Which algorithm takes logarithms, roots and polar factors of versors.

/// Logarithms and square roots by inverse scaling and squaring: the type, the type of all even
/// elements and that of bivectors.
#[doc(hidden)]
#[macro_export]
macro_rules! iterated_functions {
    ($Name:ident => $Even:ident $Bivector:ident $log:literal $sqrt:literal) => {
        impl<T: $crate::Real> $crate::ops::Logarithm for $Name<T> {
            type Output = $Bivector<T>;
            const LONG: bool = true;
            #[doc = $log]
            fn log(self) -> ::core::option::Option<$Bivector<T>> {
                $crate::algorithm::principal_logarithm::<$Even<T>, _>($Even::from(self))
            }
        }
        impl<T: $crate::Real> $crate::ops::SquareRoot for $Name<T> {
            type Output = $Even<T>;
            const LONG: bool = true;
            #[doc = $sqrt]
            fn sqrt(self) -> ::core::option::Option<$Even<T>> {
                $crate::algorithm::principal_square_root::<$Even<T>, $Bivector<T>>($Even::from(
                    self,
                ))
            }
        }
    };
}

/// Polar normalisation of types whose `X X̃` is a number.
#[doc(hidden)]
#[macro_export]
macro_rules! renormalization {
    ($Name:ident $doc:literal) => {
        impl<T: $crate::Real> $crate::ops::Renormalize for $Name<T> {
            type Output = $Name<T>;
            $crate::inlined! {
                #[doc = $doc]
                fn renormalized(self) -> ::core::option::Option<$Name<T>> {
                    $crate::algorithm::over_norm(self)
                }
            }
        }
    };
}

/// Logarithms, roots and polar normalisation of even types: the type, the type of its roots, and
/// the types of its bivectors and four-vectors, which commute if marked so; the logarithm of unit
/// versors has a body of its own.
#[doc(hidden)]
#[macro_export]
macro_rules! versor_functions {
    (
        $logarithm:ident $commuting:ident
        $Name:ident => $Versor:ident ($Bivector:ident $Fourth:ident) $log:literal $sqrt:literal $normal:literal
        of_unit $receiver:tt $of_unit:block
    ) => {
        impl<T: $crate::Real> $crate::ops::Logarithm for $Name<T> {
            type Output = $Bivector<T>;
            $crate::inlined! {
                #[doc = $log]
                fn log(self) -> ::core::option::Option<$Bivector<T>> {
                    $crate::algorithm::$logarithm::<T, _, $Bivector<T>, $Fourth<T>>(
                        self,
                        $crate::versor_functions!(@$commuting $Bivector $Fourth),
                    )
                }
            }
            #[inline(always)]
            fn log_of_unit($receiver) -> ::core::option::Option<$Bivector<T>> $of_unit
        }
        impl<T: $crate::Real> $crate::ops::SquareRoot for $Name<T> {
            type Output = $Versor<T>;
            $crate::inlined! {
                #[doc = $sqrt]
                fn sqrt(self) -> ::core::option::Option<$Versor<T>> {
                    $crate::algorithm::square_root::<T, _, $Bivector<T>, $Fourth<T>, _>(
                        self,
                        $crate::versor_functions!(@$commuting $Bivector $Fourth),
                    )
                }
            }
        }
        impl<T: $crate::Real> $crate::ops::Renormalize for $Name<T> {
            type Output = $Versor<T>;
            $crate::inlined! {
                #[doc = $normal]
                fn renormalized(self) -> ::core::option::Option<$Versor<T>> {
                    $crate::algorithm::renormalise::<T, _, $Bivector<T>, $Fourth<T>, _>(
                        self,
                        $crate::versor_functions!(@$commuting $Bivector $Fourth),
                    )
                }
            }
        }
    };
    (@commuting $Bivector:ident $Fourth:ident) => {
        $crate::algorithm::Commutators {
            planes: |_: $Bivector<T>, _: $Fourth<T>| $Fourth::default(),
            fourths: |_: $Fourth<T>, _: $Fourth<T>| $Bivector::default(),
        }
    };
    (@general $Bivector:ident $Fourth:ident) => {
        $crate::algorithm::Commutators {
            planes: |a: $Bivector<T>, b: $Fourth<T>| -> $Fourth<T> {
                $crate::convert::pick($crate::ops::Commutator::commutator(a, b))
            },
            fourths: |a: $Fourth<T>, b: $Fourth<T>| -> $Bivector<T> {
                $crate::convert::pick($crate::ops::Commutator::commutator(a, b))
            },
        }
    };
}
