//! Vectors of `mint`: types with two, three or four coefficients, in the order of the fields.

/// `From` both ways with `Vector2`, `Vector3`, `Vector4`, and `IntoMint`.
#[cfg(feature = "mint")]
#[doc(hidden)]
#[macro_export]
macro_rules! element_mint {
    ($Name:ident $x:ident $y:ident) => {
        $crate::element_mint! { @vector $Name Vector2 $x x $y y }
    };
    ($Name:ident $x:ident $y:ident $z:ident) => {
        $crate::element_mint! { @vector $Name Vector3 $x x $y y $z z }
    };
    ($Name:ident $x:ident $y:ident $z:ident $w:ident) => {
        $crate::element_mint! { @vector $Name Vector4 $x x $y y $z z $w w }
    };
    ($Name:ident $($field:ident)*) => {};
    (@vector $Name:ident $Vector:ident $($field:ident $axis:ident)*) => {
        impl<T> ::core::convert::From<$crate::crates::mint::$Vector<T>> for $Name<T> {
            #[inline]
            fn from(vector: $crate::crates::mint::$Vector<T>) -> Self {
                $Name { $($field: vector.$axis),* }
            }
        }

        impl<T> ::core::convert::From<$Name<T>> for $crate::crates::mint::$Vector<T> {
            #[inline]
            fn from(element: $Name<T>) -> Self {
                $crate::crates::mint::$Vector { $($axis: element.$field),* }
            }
        }

        impl<T> $crate::crates::mint::IntoMint for $Name<T> {
            type MintType = $crate::crates::mint::$Vector<T>;
        }
    };
}

/// Nothing without the feature.
#[cfg(not(feature = "mint"))]
#[doc(hidden)]
#[macro_export]
macro_rules! element_mint {
    ($($tokens:tt)*) => {};
}
