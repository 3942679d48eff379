//! Products of two operands: unrolled, vanishing, shared with another function, by reference.

/// Functions of two operands with bodies of their own, as [`kernel!`](crate::kernel) reads them: one
/// implementation for each.
#[doc(hidden)]
#[macro_export]
macro_rules! unrolled {
    (impl<T: $Bound:ident> ApplyUnit for $Left:ident<T> {$(
        $(#[$doc:meta])*
        fn $method:ident($this:ident, $multiple:ident: $Multiple:ty, $argument:ident: $Right:ty) -> $Output:ty { $($body:tt)* }
    )*}) => {$(
        impl<T: $Bound> ApplyUnit<$Right> for $Left<T> {
            type Image = $Output;
            $crate::inlined! {
                $(#[$doc])*
                fn $method($this, $multiple: $Multiple, $argument: $Right) -> $Output {
                    $crate::kernel! { $($body)* }
                }
            }
        }
    )*};
    (impl<T: $Bound:ident> $Trait:ident for $Left:ident<T> {$(
        $(#[$doc:meta])*
        fn $method:ident($this:ident, $argument:ident: $Right:ty) -> $Output:ty { $($body:tt)* }
    )*}) => {$(
        impl<T: $Bound> $Trait<$Right> for $Left<T> {
            type Output = $Output;
            $crate::inlined! {
                $(#[$doc])*
                fn $method($this, $argument: $Right) -> $Output {
                    $crate::kernel! { $($body)* }
                }
            }
        }
    )*};
}

/// Products that vanish identically.
#[doc(hidden)]
#[macro_export]
macro_rules! vanishing {
    (Scalar $trait:ident $method:ident $Left:ident: $($Right:ident),*) => {$(
        impl<T: $crate::Scalar> $crate::ops::$trait<$Right<T>> for $Left<T> {
            type Output = Scalar<T>;
            $crate::inlined! {
                #[doc = "Vanishes identically for these types; no operations."]
                fn $method(self, _: $Right<T>) -> Scalar<T> {
                    Scalar { s: T::ZERO }
                }
            }
        }
    )*};
    (number $trait:ident $method:ident $Left:ident: $($Right:ident),*) => {$(
        impl<T: $crate::Scalar> $crate::ops::$trait<$Right<T>> for $Left<T> {
            type Output = T;
            $crate::inlined! {
                #[doc = "Vanishes identically for these types; no operations."]
                fn $method(self, _: $Right<T>) -> T {
                    T::ZERO
                }
            }
        }
    )*};
}

/// Products that are another function: of the same operands, of the operands exchanged, or of
/// the operands widened to the types of their parity.
#[doc(hidden)]
#[macro_export]
macro_rules! shared {
    ($trait:ident $method:ident $Left:ident: $($kind:ident $Right:ident => $Output:ident ($($word:ident)*) $doc:literal,)*) => {$(
        impl<T: $crate::Scalar> $crate::ops::$trait<$Right<T>> for $Left<T> {
            type Output = $Output<T>;
            $crate::inlined! {
                #[doc = $doc]
                fn $method(self, b: $Right<T>) -> $Output<T> {
                    $crate::shared!(@$kind $method self b $($word)*)
                }
            }
        }
    )*};
    ($trait:ident $method:ident $Left:ident number: $($kind:ident $Right:ident ($($word:ident)*) $doc:literal,)*) => {$(
        impl<T: $crate::Scalar> $crate::ops::$trait<$Right<T>> for $Left<T> {
            type Output = T;
            $crate::inlined! {
                #[doc = $doc]
                fn $method(self, b: $Right<T>) -> T {
                    $crate::shared!(@$kind $method self b $($word)*)
                }
            }
        }
    )*};
    (@same $own:ident $a:ident $b:ident $method:ident) => {
        $a.$method($b)
    };
    (@swapped $own:ident $a:ident $b:ident $method:ident) => {
        $b.$method($a)
    };
    (@minus_same $own:ident $a:ident $b:ident $method:ident) => {
        -$a.$method($b)
    };
    (@minus_swapped $own:ident $a:ident $b:ident $method:ident) => {
        -$b.$method($a)
    };
    (@reversed $own:ident $a:ident $b:ident $method:ident) => {
        $b.$method($a).reverse()
    };
    (@minus_reversed $own:ident $a:ident $b:ident $method:ident) => {
        -$b.$method($a).reverse()
    };
    (@number $own:ident $a:ident $b:ident $method:ident) => {
        $a.$method($b).s
    };
    (@number_swapped $own:ident $a:ident $b:ident $method:ident) => {
        $b.$method($a)
    };
    (@term_by_term $own:ident $a:ident $b:ident $Left:ident $Right:ident) => {
        $crate::ops::TermByTerm::term_by_term($Left::from($a), $Right::from($b))
    };
    (@widened $own:ident $a:ident $b:ident $Left:ident $Right:ident) => {
        $Left::from($a).$own($Right::from($b))
    };
}

/// The products that have operators, with a reference on the right.
#[doc(hidden)]
#[macro_export]
macro_rules! references {
    ($Left:ident: $($Right:ident),*) => {
        $($crate::references! { @each $Left $Right
            Geometric geometric, Wedge wedge, Inner inner, Regressive regressive,
            LeftContract left_contract, Quotient quotient
        })*
    };
    (@each $Left:ident $Right:ident $($trait:ident $method:ident),*) => {$(
        impl<'b, T: ::core::marker::Copy> $crate::ops::$trait<&'b $Right<T>> for $Left<T>
        where
            $Left<T>: $crate::ops::$trait<$Right<T>>,
        {
            type Output = <$Left<T> as $crate::ops::$trait<$Right<T>>>::Output;
            $crate::inlined! {
                /// The same with the value.
                fn $method(self, b: &'b $Right<T>) -> Self::Output {
                    $crate::ops::$trait::$method(self, *b)
                }
            }
        }
    )*};
}
