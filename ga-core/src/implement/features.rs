//! Traits of other crates on every generated type: ga-core's features decide, not the user's.
//!
//! Each macro comes twice, full with its feature and empty without it, so that generated code
//! calls all of them whatever the features are.

mod approx;
mod bytemuck;
mod glam;
mod mint;
mod nalgebra;
mod rand;
mod serde;

/// The crates behind the features, where generated code of any crate finds them.
#[doc(hidden)]
pub mod crates {
    #[cfg(feature = "approx")]
    pub use ::approx;
    #[cfg(feature = "bytemuck")]
    pub use ::bytemuck;
    #[cfg(feature = "glam")]
    pub use ::glam;
    #[cfg(feature = "mint")]
    pub use ::mint;
    #[cfg(feature = "nalgebra")]
    pub use ::nalgebra;
    #[cfg(feature = "rand")]
    pub use ::rand;
    #[cfg(feature = "serde")]
    pub use ::serde_core as serde;

    #[cfg(feature = "serde")]
    pub use super::serde::deserialize;
}

/// The traits of other crates for a type with these fields.
#[doc(hidden)]
#[macro_export]
macro_rules! element_features {
    ($Name:ident { $($field:ident $label:literal,)* }) => {
        $crate::element_approx! { $Name $($field)* }
        $crate::element_bytemuck! { $Name $($field)* }
        $crate::element_glam! { $Name $($field)* }
        $crate::element_mint! { $Name $($field)* }
        $crate::element_nalgebra! { $Name $($field)* }
        $crate::element_rand! { $Name $($field)* }
        $crate::element_serde! { $Name $($field)* }
    };
}
