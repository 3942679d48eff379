//! Casts to bytes: the coefficients one after the other, in the order of the fields.

/// `Zeroable` and `Pod`.
///
/// Sound because generated types are `#[repr(C)]` structs of nothing but coefficients of one
/// type, so there is no padding; the assertion refuses a struct declared with a larger
/// alignment. Lints look at the place where code was written, which is here: a crate that
/// forbids unsafe code can declare algebras with this feature on.
#[cfg(feature = "bytemuck")]
#[doc(hidden)]
#[macro_export]
macro_rules! element_bytemuck {
    ($Name:ident $($field:ident)*) => {
        const _: () = ::core::assert!(
            ::core::mem::size_of::<$Name<u8>>() == $crate::count!($($field)*),
            "the type has padding"
        );

        unsafe impl<T: $crate::crates::bytemuck::Zeroable> $crate::crates::bytemuck::Zeroable
            for $Name<T>
        {
        }

        unsafe impl<T: $crate::crates::bytemuck::Pod> $crate::crates::bytemuck::Pod for $Name<T> {}
    };
}

/// Nothing without the feature.
#[cfg(not(feature = "bytemuck"))]
#[doc(hidden)]
#[macro_export]
macro_rules! element_bytemuck {
    ($($tokens:tt)*) => {};
}
