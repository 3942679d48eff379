//! Which algorithm inverts a type, and quotients by what is inverted.

/// Inverses of types whose `X X̃` is a scalar.
#[doc(hidden)]
#[macro_export]
macro_rules! inverse {
    ($Name:ident => $Output:ident $doc:literal) => {
        impl<T: $crate::Field> $crate::ops::Inverse for $Name<T> {
            type Number = T;
            type Output = $Output<T>;
            $crate::inlined! {
                /// The squared norm `X X̃`, at the cost of `norm_squared`.
                fn determinant(self) -> T {
                    $crate::ops::NormSquared::norm_squared(self)
                }
            }
            $crate::inlined! {
                #[doc = $doc]
                fn adjugate(self) -> $Output<T> {
                    $Output::from($crate::ops::Reverse::reverse(self))
                }
            }
            $crate::inlined! {
                /// The adjugate times a number, one multiplication a coefficient.
                fn scale(adjugate: $Output<T>, factor: T) -> $Output<T> {
                    adjugate * factor
                }
            }
        }
    };
}

/// Inverses by the Faddeev–LeVerrier algorithm on the whole algebra.
#[doc(hidden)]
#[macro_export]
macro_rules! general_inverse {
    ($Name:ident => $Output:ident in $All:ident $count:literal $doc:literal) => {
        impl<T: $crate::Field> $crate::ops::Inverse for $Name<T> {
            type Number = T;
            type Output = $Output<T>;
            const LONG: bool = true;
            $crate::inlined! {
                #[doc = $doc]
                fn determinant(self) -> T {
                    $crate::algorithm::adjugate::<$All<T>>($All::from(self), $count).1
                }
            }
            #[doc = $doc]
            fn adjugate(self) -> $Output<T> {
                $crate::convert::pick(
                    $crate::algorithm::adjugate::<$All<T>>($All::from(self), $count).0,
                )
            }
            $crate::inlined! {
                /// The adjugate times a number, one multiplication a coefficient.
                fn scale(adjugate: $Output<T>, factor: T) -> $Output<T> {
                    adjugate * factor
                }
            }
            /// Both at once by one recursion, a division, and a multiplication a coefficient.
            fn inverse(self) -> ::core::option::Option<$Output<T>> {
                let (adjugate, determinant) =
                    $crate::algorithm::adjugate::<$All<T>>($All::from(self), $count);
                determinant.is_invertible().then(|| {
                    $crate::convert::pick::<_, $Output<T>>(adjugate) * (T::ONE / determinant)
                })
            }
            /// Both at once by one recursion, a division, and a multiplication a coefficient.
            fn reciprocal(self) -> $Output<T> {
                let (adjugate, determinant) =
                    $crate::algorithm::adjugate::<$All<T>>($All::from(self), $count);
                $crate::convert::pick::<_, $Output<T>>(adjugate) * (T::ONE / determinant)
            }
        }
    };
}

/// Quotients `a b⁻¹`.
#[doc(hidden)]
#[macro_export]
macro_rules! quotients {
    ($Left:ident: $($Right:ident $doc:literal),*) => {$(
        impl<T: $crate::Field> $crate::ops::Quotient<$Right<T>> for $Left<T> {
            type Output = <$Left<T> as $crate::ops::Geometric<<$Right<T> as $crate::ops::Inverse>::Output>>::Output;
            $crate::inlined! {
                #[doc = $doc]
                fn quotient(self, b: $Right<T>) -> Self::Output {
                    $crate::ops::Geometric::geometric(self, $crate::ops::Inverse::reciprocal(b))
                }
            }
        }
    )*};
}
