//! Roots and transcendental functions of floating-point numbers.

use super::elementary::Elementary;
use super::{Real, Scalar};

/// Coefficients 1/(2n)! of cosh √a.
const COSH: [f64; 10] = reciprocal_factorials(0);
/// Coefficients 1/(2n+1)! of sinh √a / √a.
const SINHC: [f64; 10] = reciprocal_factorials(1);

/// Reciprocals of the factorials of `first`, `first` + 2, …; with ten of them the series for
/// |a| ≤ 1 ends below 1/20! ≈ 4e−19.
const fn reciprocal_factorials(first: u64) -> [f64; 10] {
    let mut coefficients = [1.0; 10];
    let mut index = 1;
    let mut factorial = 1_u64;
    while index < coefficients.len() {
        let n = 2 * index as u64 + first;
        factorial *= (n - 1) * n;
        coefficients[index] = 1.0 / factorial as f64;
        index += 1;
    }
    coefficients
}

macro_rules! real {
    ($float:ident) => {
        impl Real for $float {
            const PI: Self = core::$float::consts::PI;
            const EPSILON: Self = core::primitive::$float::EPSILON;

            fn from_f64(value: f64) -> Self {
                value as $float
            }

            fn at_value(self, value: Self) -> Self {
                value
            }

            fn abs(self) -> Self {
                core::primitive::$float::abs(self)
            }

            fn sqrt(self) -> Self {
                Elementary::sqrt(self)
            }

            fn sin_cos(self) -> (Self, Self) {
                Elementary::sin_cos(self)
            }

            fn atan2(self, x: Self) -> Self {
                Elementary::atan2(self, x)
            }

            fn exp(self) -> Self {
                Elementary::exp(self)
            }

            fn ln(self) -> Self {
                Elementary::ln(self)
            }

            fn cosh_sinhc(self) -> (Self, Self) {
                if Real::abs(self) <= Self::ONE {
                    let series = |coefficients: [f64; 10]| {
                        let powers = coefficients.iter().rev();
                        powers.fold(0.0, |sum, &coefficient| sum * self + coefficient as $float)
                    };
                    return (series(COSH), series(SINHC));
                }
                let root = Elementary::sqrt(Real::abs(self));
                if self < 0.0 {
                    let (sin, cos) = Elementary::sin_cos(root);
                    return (cos, sin / root);
                }
                let (cosh, sinh) = (Elementary::cosh(root), Elementary::sinh(root));
                (cosh, if root.is_finite() { sinh / root } else { sinh })
            }

            fn log_factor(self, square: Self) -> Option<Self> {
                if !self.is_finite() || !square.is_finite() {
                    return None;
                }
                let root = Elementary::sqrt(Real::abs(square));
                let factor = if square < 0.0 {
                    Elementary::atan2(root, self) / root
                } else if self <= 0.0 {
                    return None;
                } else if root > self / 2.0 {
                    // The difference of c and √s would be lost in their quotient.
                    Elementary::asinh(root) / root
                } else if root / self > 0.0 {
                    Elementary::atanh(root / self) / root
                } else {
                    self.recip()
                };
                factor.is_finite().then_some(factor)
            }

            fn is_finite(self) -> bool {
                core::primitive::$float::is_finite(self)
            }

            fn all_le(self, other: Self) -> bool {
                self <= other
            }

            fn select_le(self, bound: Self, then: Self, otherwise: Self) -> Self {
                if self <= bound { then } else { otherwise }
            }
        }
    };
}

real!(f32);
real!(f64);
