//! Column vectors of `nalgebra`: the coefficients of every type, in the order of the fields.

/// `From` both ways with `SVector` of as many components.
#[cfg(feature = "nalgebra")]
#[doc(hidden)]
#[macro_export]
macro_rules! element_nalgebra {
    ($Name:ident $($field:ident)*) => {
        impl<T: $crate::crates::nalgebra::Scalar>
            ::core::convert::From<
                $crate::crates::nalgebra::SVector<T, { $crate::count!($($field)*) }>,
            > for $Name<T>
        {
            #[inline]
            fn from(
                vector: $crate::crates::nalgebra::SVector<T, { $crate::count!($($field)*) }>,
            ) -> Self {
                let [[$($field),*]] = vector.data.0;
                $Name { $($field),* }
            }
        }

        impl<T: $crate::crates::nalgebra::Scalar> ::core::convert::From<$Name<T>>
            for $crate::crates::nalgebra::SVector<T, { $crate::count!($($field)*) }>
        {
            #[inline]
            fn from(element: $Name<T>) -> Self {
                Self::from([$(element.$field),*])
            }
        }
    };
}

/// Nothing without the feature.
#[cfg(not(feature = "nalgebra"))]
#[doc(hidden)]
#[macro_export]
macro_rules! element_nalgebra {
    ($($tokens:tt)*) => {};
}
