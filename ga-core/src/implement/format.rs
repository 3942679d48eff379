//! How elements print, and how they are indexed.

/// `Display`: `1 + 2.5 e12`, fixed coefficients included; and `Index` by blade.
#[doc(hidden)]
#[macro_export]
macro_rules! element_format {
    ($Name:ident { $($field:ident $label:literal,)* } { $($fixed_label:literal $numerator:literal $denominator:literal,)* }) => {
        impl<T: $crate::Scalar + ::core::fmt::Display> ::core::fmt::Display for $Name<T> {
            fn fmt(&self, f: &mut ::core::fmt::Formatter<'_>) -> ::core::fmt::Result {
                let fixed: &[(&str, i64, i64)] = &[$(($fixed_label, $numerator, $denominator)),*];
                let free: &[(&str, T)] = &[$(($label, self.$field)),*];
                $crate::convert::display(f, fixed, free)
            }
        }

        impl<T: $crate::Scalar> ::core::ops::Index<$crate::Blade> for $Name<T> {
            type Output = T;

            /// The stored coefficient of a blade, in the orientation of its field.
            ///
            /// # Panics
            /// If the type does not store the blade; `get` answers with an `Option` instead.
            fn index(&self, blade: $crate::Blade) -> &T {
                let stored = <Self as $crate::ops::Element>::BLADES;
                let fields = [$(&self.$field),*];
                match stored.iter().zip(fields).find(|((own, _), _)| *own == blade) {
                    ::core::option::Option::Some((_, value)) => value,
                    ::core::option::Option::None => {
                        $crate::convert::not_stored(stringify!($Name), blade)
                    }
                }
            }
        }
    };
}
