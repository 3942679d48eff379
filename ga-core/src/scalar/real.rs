//! Lanes are real numbers: which function computes what.

use super::functions::circular::sin_cos;
use super::functions::exponential::exp;
use super::functions::inverse_tangent::atan2;
use super::functions::logarithm::ln;
use super::functions::rotors;
use super::lanes::Lanes;
use super::precision::Precision;
use super::{Computation, Real};

impl<L: Lanes> Real for L {
    const PI: Self = <L as Lanes>::PI;
    const EPSILON: Self = <L as Lanes>::EPSILON;

    #[inline(always)]
    fn from_f64(value: f64) -> Self {
        L::splat(L::Float::rounded(value))
    }

    #[inline(always)]
    fn at_value(self, value: Self) -> Self {
        value
    }

    #[inline(always)]
    fn abs(self) -> Self {
        self.magnitude()
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        self.square_root()
    }

    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        sin_cos(self)
    }

    #[inline(always)]
    fn atan2(self, x: Self) -> Self {
        atan2(self, x)
    }

    #[inline(always)]
    fn exp(self) -> Self {
        exp(self)
    }

    #[inline(always)]
    fn ln(self) -> Self {
        ln(self)
    }

    #[inline(always)]
    fn cosh_sinhc(self) -> (Self, Self) {
        rotors::cosh_sinhc(self)
    }

    #[inline(always)]
    fn cosh_sinhc_slope(self) -> (Self, Self, Self) {
        rotors::cosh_sinhc_slope(self)
    }

    #[inline(always)]
    fn log_factor(self, square: Self) -> Option<Self> {
        rotors::log_factor(self, square)
    }

    #[inline(always)]
    fn log_factor_slope(self, square: Self) -> Option<(Self, Self)> {
        rotors::log_factor_slope(self, square)
    }

    #[inline(always)]
    fn is_finite(self) -> bool {
        L::all(self.magnitude().is_at_most(L::splat(L::Float::LARGEST)))
    }

    #[inline(always)]
    fn all_le(self, other: Self) -> bool {
        L::all(self.is_at_most(other))
    }

    #[inline(always)]
    fn select_le(self, bound: Self, then: Self, otherwise: Self) -> Self {
        L::select(self.is_at_most(bound), then, otherwise)
    }

    #[inline(always)]
    fn outlined<C: Computation>(computation: C) -> C::Output {
        <L as Lanes>::outlined(computation)
    }
}
