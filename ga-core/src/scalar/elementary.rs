//! Which library computes the elementary functions: the standard one where it is there, `libm`
//! elsewhere.

/// The elementary functions that the core library lacks, with their usual meaning.
pub(super) trait Elementary {
    fn sqrt(self) -> Self;
    fn sin_cos(self) -> (Self, Self)
    where
        Self: Sized;
    fn atan2(self, x: Self) -> Self;
    fn exp(self) -> Self;
    fn ln(self) -> Self;
    fn sinh(self) -> Self;
    fn cosh(self) -> Self;
    fn asinh(self) -> Self;
    fn atanh(self) -> Self;
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
            fn exp(self) -> Self {
                std::primitive::$float::exp(self)
            }
            fn ln(self) -> Self {
                std::primitive::$float::ln(self)
            }
            fn sinh(self) -> Self {
                std::primitive::$float::sinh(self)
            }
            fn cosh(self) -> Self {
                std::primitive::$float::cosh(self)
            }
            fn asinh(self) -> Self {
                std::primitive::$float::asinh(self)
            }
            fn atanh(self) -> Self {
                std::primitive::$float::atanh(self)
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
    ($float:ident: $sqrt:ident $sincos:ident $atan2:ident $exp:ident $log:ident $sinh:ident
     $cosh:ident $asinh:ident $atanh:ident) => {
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
            fn exp(self) -> Self {
                libm::$exp(self)
            }
            fn ln(self) -> Self {
                libm::$log(self)
            }
            fn sinh(self) -> Self {
                libm::$sinh(self)
            }
            fn cosh(self) -> Self {
                libm::$cosh(self)
            }
            fn asinh(self) -> Self {
                libm::$asinh(self)
            }
            fn atanh(self) -> Self {
                libm::$atanh(self)
            }
        }
    };
}

#[cfg(not(feature = "std"))]
elementary!(f32: sqrtf sincosf atan2f expf logf sinhf coshf asinhf atanhf);
#[cfg(not(feature = "std"))]
elementary!(f64: sqrt sincos atan2 exp log sinh cosh asinh atanh);
