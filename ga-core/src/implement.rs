//! What every generated type has, whatever its algebra; called by generated code only.
//!
//! The macros are public because generated code stands in other crates. Their input is a type
//! with its fields, each with label, bitmask and orientation sign.

mod arithmetic;
pub mod features;
mod format;
mod lists;
mod methods;

/// A function that other crates may inline.
#[cfg(not(feature = "inlined"))]
#[doc(hidden)]
#[macro_export]
macro_rules! inlined {
    ($($function:tt)*) => {
        #[inline]
        $($function)*
    };
}

/// A function that is inlined whatever its length, as lanes need it: their registers are those of
/// the function that a kernel was inlined into. Not so in builds for debugging.
#[cfg(feature = "inlined")]
#[doc(hidden)]
#[macro_export]
macro_rules! inlined {
    ($($function:tt)*) => {
        #[cfg_attr(debug_assertions, inline)]
        #[cfg_attr(not(debug_assertions), inline(always))]
        $($function)*
    };
}

/// Everything a type has apart from products with other types.
#[doc(hidden)]
#[macro_export]
macro_rules! element {
    (
        $Name:ident sums $Sum:ident
        fields { $($field:ident $label:literal $mask:literal $sign:literal,)* }
        fixed { $($fixed_label:literal $fixed_mask:literal $fixed_sign:literal ($numerator:literal, $denominator:literal),)* }
        $(null { $($square:literal [$($term:tt)*])* })?
    ) => {
        impl<T: $crate::Scalar> $crate::ops::Element for $Name<T> {
            type Number = T;
            type Over<U: $crate::Scalar> = $Name<U>;
            const BLADES: &'static [($crate::Blade, i8)] =
                &[$(($crate::Blade::new($mask), $sign)),*];
            const FIXED: &'static [($crate::Blade, i8, i64, i64)] =
                &[$(($crate::Blade::new($fixed_mask), $fixed_sign, $numerator, $denominator)),*];
            const LABELS: &'static [&'static str] = &[$($label),*];
            $(const NULL: &'static [$crate::ops::VanishingForm] =
                &[$(($crate::Blade::new($square), &[$($term),*])),*];)?

            $crate::inlined! {
                fn at(&self, position: usize) -> T {
                    match [$(self.$field),*].get(position) {
                        ::core::option::Option::Some(value) => *value,
                        ::core::option::Option::None => T::ZERO,
                    }
                }
            }

            $crate::inlined! {
                fn from_fn(mut coefficient: impl ::core::ops::FnMut(usize) -> T) -> Self {
                    let mut position = 0;
                    let mut next = || {
                        let value = coefficient(position);
                        position += 1;
                        value
                    };
                    $Name { $($field: next()),* }
                }
            }

            $crate::inlined! {
                fn place(&self, position: usize) -> ::core::option::Option<&T> {
                    let mut before = 0_usize;
                    $(
                        if before == position {
                            return ::core::option::Option::Some(&self.$field);
                        }
                        before += 1;
                    )*
                    let _ = before;
                    ::core::option::Option::None
                }
            }

            $crate::inlined! {
                fn place_mut(&mut self, position: usize) -> ::core::option::Option<&mut T> {
                    let mut before = 0_usize;
                    $(
                        if before == position {
                            return ::core::option::Option::Some(&mut self.$field);
                        }
                        before += 1;
                    )*
                    let _ = before;
                    ::core::option::Option::None
                }
            }
        }

        $crate::element_methods! { $Name $Sum { $($field $label $mask $sign,)* } }
        $crate::element_arithmetic! { $Name $Sum { $($field,)* } { $($fixed_mask)* $([$($square)*])? } }
        $crate::element_operators! { $Name }
        $crate::element_format! { $Name { $($field $label,)* } { $($fixed_label $numerator $denominator,)* } }
        $crate::element_features! { $Name { $($field $label,)* } }
    };
}

/// Conversion between coefficients by bitmask and the type of all blades.
#[doc(hidden)]
#[macro_export]
macro_rules! masks {
    ($count:literal $($sign:tt $field:ident),*) => {
        impl<T: $crate::Scalar> Multivector<T> {
            $crate::inlined! {
                /// The multivector with these coefficients, indexed by the bitmask of their blades
                /// (first basis vector 1, second 2, third 4, …), vectors in increasing order
                /// whatever the spelling of the fields.
                pub fn from_masks(coefficients: [T; $count]) -> Self {
                    let [$($field),*] = coefficients;
                    Self { $($field: $crate::signed!($sign $field)),* }
                }
            }

            $crate::inlined! {
                /// The coefficients indexed by the bitmask of their blades, the inverse of
                /// [`from_masks`](Self::from_masks).
                pub fn to_masks(self) -> [T; $count] {
                    [$($crate::signed!($sign (self.$field))),*]
                }
            }
        }
    };
}

/// A value with a literal sign.
#[doc(hidden)]
#[macro_export]
macro_rules! signed {
    (+ $value:expr) => {
        $value
    };
    (- $value:expr) => {
        -$value
    };
}
