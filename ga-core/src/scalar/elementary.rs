//! Which library computes roots, and the circular functions of angles that are too large for the
//! polynomials: the standard one where it is there, `libm` elsewhere.

/// Elementary functions that the core library lacks, with their usual meaning.
pub trait Elementary {
    /// The square root, rounded correctly.
    fn sqrt(self) -> Self;
    /// Sine and cosine of an angle in radians.
    fn sin_cos(self) -> (Self, Self)
    where
        Self: Sized;
    /// The angle of the point (`x`, `self`) in radians.
    fn atan2(self, x: Self) -> Self;
}

#[cfg(feature = "std")]
macro_rules! elementary {
    ($float:ident) => {
        impl Elementary for $float {
            fn sqrt(self) -> Self {
                std::primitive::$float::sqrt(self)
            }
            fn sin_cos(self) -> (Self, Self) {
                std::primitive::$float::sin_cos(self)
            }
            fn atan2(self, x: Self) -> Self {
                std::primitive::$float::atan2(self, x)
            }
        }
    };
}

#[cfg(feature = "std")]
elementary!(f32);
#[cfg(feature = "std")]
elementary!(f64);

#[cfg(not(feature = "std"))]
macro_rules! elementary {
    ($float:ident: $sqrt:ident $sincos:ident $atan2:ident) => {
        impl Elementary for $float {
            fn sqrt(self) -> Self {
                libm::$sqrt(self)
            }
            fn sin_cos(self) -> (Self, Self) {
                libm::$sincos(self)
            }
            fn atan2(self, x: Self) -> Self {
                libm::$atan2(self, x)
            }
        }
    };
}

#[cfg(not(feature = "std"))]
elementary!(f32: sqrtf sincosf atan2f);
#[cfg(not(feature = "std"))]
elementary!(f64: sqrt sincos atan2);
