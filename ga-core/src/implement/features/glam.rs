//! Vectors of `glam`: types with two, three or four coefficients, in the order of the fields.

/// `From` both ways with `Vec2`, `Vec3`, `Vec4` for `f32` and `DVec2`, `DVec3`, `DVec4` for
/// `f64`.
#[cfg(feature = "glam")]
#[doc(hidden)]
#[macro_export]
macro_rules! element_glam {
    ($Name:ident $x:ident $y:ident) => {
        $crate::element_glam! { @vector $Name f32 Vec2 $x x $y y }
        $crate::element_glam! { @vector $Name f64 DVec2 $x x $y y }
    };
    ($Name:ident $x:ident $y:ident $z:ident) => {
        $crate::element_glam! { @vector $Name f32 Vec3 $x x $y y $z z }
        $crate::element_glam! { @vector $Name f64 DVec3 $x x $y y $z z }
    };
    ($Name:ident $x:ident $y:ident $z:ident $w:ident) => {
        $crate::element_glam! { @vector $Name f32 Vec4 $x x $y y $z z $w w }
        $crate::element_glam! { @vector $Name f64 DVec4 $x x $y y $z z $w w }
    };
    ($Name:ident $($field:ident)*) => {};
    (@vector $Name:ident $number:ident $Vector:ident $($field:ident $axis:ident)*) => {
        impl ::core::convert::From<$crate::crates::glam::$Vector> for $Name<$number> {
            #[inline]
            fn from(vector: $crate::crates::glam::$Vector) -> Self {
                $Name { $($field: vector.$axis),* }
            }
        }

        impl ::core::convert::From<$Name<$number>> for $crate::crates::glam::$Vector {
            #[inline]
            fn from(element: $Name<$number>) -> Self {
                $crate::crates::glam::$Vector::new($(element.$field),*)
            }
        }
    };
}

/// Nothing without the feature.
#[cfg(not(feature = "glam"))]
#[doc(hidden)]
#[macro_export]
macro_rules! element_glam {
    ($($tokens:tt)*) => {};
}
