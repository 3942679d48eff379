//! Serialisation: a struct of the stored coefficients under the names of their fields.
//!
//! Fixed coefficients are not written. Reading takes a map with every field exactly once, in
//! any order, or a sequence in the order of the fields, as formats without names give. Which
//! numbers are accepted is up to the format and the type of the numbers: where a format can
//! write a float that is not finite, it is read back as it was.

#[cfg(feature = "serde")]
mod reader;

#[cfg(feature = "serde")]
pub use reader::deserialize;

/// `Serialize` and `Deserialize` for whatever numbers have them.
#[cfg(feature = "serde")]
#[doc(hidden)]
#[macro_export]
macro_rules! element_serde {
    ($Name:ident $($field:ident)*) => {
        impl<T: $crate::crates::serde::Serialize> $crate::crates::serde::Serialize for $Name<T> {
            fn serialize<S: $crate::crates::serde::Serializer>(
                &self,
                serializer: S,
            ) -> ::core::result::Result<S::Ok, S::Error> {
                let mut fields = $crate::crates::serde::Serializer::serialize_struct(
                    serializer,
                    ::core::stringify!($Name),
                    $crate::count!($($field)*),
                )?;
                $($crate::crates::serde::ser::SerializeStruct::serialize_field(
                    &mut fields,
                    ::core::stringify!($field),
                    &self.$field,
                )?;)*
                $crate::crates::serde::ser::SerializeStruct::end(fields)
            }
        }

        impl<'de, T> $crate::crates::serde::Deserialize<'de> for $Name<T>
        where
            T: $crate::Scalar + $crate::crates::serde::Deserialize<'de>,
        {
            fn deserialize<D: $crate::crates::serde::Deserializer<'de>>(
                deserializer: D,
            ) -> ::core::result::Result<Self, D::Error> {
                const FIELDS: &[&str; { $crate::count!($($field)*) }] =
                    &[$(::core::stringify!($field)),*];
                let name = ::core::stringify!($Name);
                let [$($field),*] = $crate::crates::deserialize(deserializer, name, FIELDS)?;
                ::core::result::Result::Ok($Name { $($field),* })
            }
        }
    };
}

/// Nothing without the feature.
#[cfg(not(feature = "serde"))]
#[doc(hidden)]
#[macro_export]
macro_rules! element_serde {
    ($($tokens:tt)*) => {};
}
