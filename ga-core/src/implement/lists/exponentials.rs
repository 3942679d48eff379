//! Which algorithm exponentiates a type, and how bivectors are split.

/// Exponentials of types with fixed coefficients: that of the type of their sums.
#[doc(hidden)]
#[macro_export]
macro_rules! widened_exponential {
    ($Name:ident => $Wide:ident) => {
        impl<T: $crate::Real> $crate::ops::Exponential for $Name<T>
        where
            $Wide<T>: $crate::ops::Exponential + ::core::convert::From<$Name<T>>,
        {
            type Output = <$Wide<T> as $crate::ops::Exponential>::Output;
            const LONG: bool = <$Wide<T> as $crate::ops::Exponential>::LONG;
            $crate::inlined! {
                /// The exponential of the same element without fixed coefficients, at its cost.
                fn exp(self) -> Self::Output {
                    $crate::ops::Exponential::exp($Wide::from(self))
                }
            }
        }
    };
}

/// Exponentials by scaling and squaring.
#[doc(hidden)]
#[macro_export]
macro_rules! series_exponential {
    ($Name:ident => $Output:ident $doc:literal) => {
        impl<T: $crate::Real> $crate::ops::Exponential for $Name<T> {
            type Output = $Output<T>;
            const LONG: bool = true;
            #[doc = $doc]
            fn exp(self) -> $Output<T> {
                $crate::algorithm::exponential($Output::from(self))
            }
        }
    };
}

/// Exponentials of bivectors: the type, the type of the exponential, and the types of commuting
/// bivectors and of outer squares.
#[doc(hidden)]
#[macro_export]
macro_rules! bivector_exponential {
    ($Name:ident => $Versor:ident ($Bivector:ident $Fourth:ident) $doc:literal) => {
        impl<T: $crate::Real> $crate::ops::Exponential for $Name<T> {
            type Output = $Versor<T>;
            $crate::inlined! {
                #[doc = $doc]
                fn exp(self) -> $Versor<T> {
                    $crate::algorithm::bivector_exponential::<T, $Bivector<T>, $Fourth<T>, _>(
                        $Bivector::from(self),
                    )
                }
            }
        }
    };
}

/// Splits of bivectors into commuting blades, in the same types.
#[doc(hidden)]
#[macro_export]
macro_rules! commuting_split {
    ($Name:ident => $Versor:ident ($Bivector:ident $Fourth:ident) $doc:literal) => {
        impl<T: $crate::Real> $crate::ops::SplitCommuting for $Name<T> {
            type Output = $Bivector<T>;
            $crate::inlined! {
                #[doc = $doc]
                fn split_commuting(self) -> $crate::algorithm::Split<$Bivector<T>> {
                    $crate::algorithm::split::<T, $Bivector<T>, $Fourth<T>>($Bivector::from(self))
                }
            }
        }
    };
}
