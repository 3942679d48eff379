//! Random elements: every coefficient drawn by itself.

/// `StandardUniform` for whatever numbers have it, floats in [0, 1).
///
/// The coefficients are independent: a versor drawn this way is no unit versor until it is
/// normalised, and a type that holds null vectors among others draws the others too.
#[cfg(feature = "rand")]
#[doc(hidden)]
#[macro_export]
macro_rules! element_rand {
    ($Name:ident $($field:ident)*) => {
        impl<T> $crate::crates::rand::distr::Distribution<$Name<T>>
            for $crate::crates::rand::distr::StandardUniform
        where
            $crate::crates::rand::distr::StandardUniform:
                $crate::crates::rand::distr::Distribution<T>,
        {
            fn sample<R: $crate::crates::rand::Rng + ?Sized>(&self, rng: &mut R) -> $Name<T> {
                $Name {
                    $($field: $crate::crates::rand::distr::Distribution::<T>::sample(self, rng)),*
                }
            }
        }
    };
}

/// Nothing without the feature.
#[cfg(not(feature = "rand"))]
#[doc(hidden)]
#[macro_export]
macro_rules! element_rand {
    ($($tokens:tt)*) => {};
}
