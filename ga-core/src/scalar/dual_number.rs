//! Dual numbers carry a derivative through every computation.

use core::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use super::{Field, Real, Scalar};

/// A dual number `re` + `eps` ε with ε² = 0: a value and its derivative.
///
/// Evaluating a function at `Dual::variable(x)` gives its value in `re` and its derivative in
/// `eps`. Nested dual numbers give higher derivatives.
///
/// Where a derivative does not exist, a zero `eps` stays zero. With a non-zero one, `sqrt` and
/// `ln` at 0 have an infinite `eps`, and that of `abs` at 0 is taken from the left. Comparisons
/// look at `re` alone, equality at both parts.
///
/// ```
/// use ga_core::{Dual, Real};
///
/// let x = Dual::variable(2.0_f64);
/// let y = x * x * x;
/// assert_eq!((y.re, y.eps), (8.0, 12.0));
/// assert_eq!(Dual::variable(0.25_f64).sqrt(), Dual::new(0.5, 1.0));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Dual<T> {
    /// The value.
    pub re: T,
    /// The derivative.
    pub eps: T,
}

impl<T> Dual<T> {
    /// The number `re` + `eps` ε.
    pub const fn new(re: T, eps: T) -> Dual<T> {
        Dual { re, eps }
    }
}

impl<T: Scalar> Dual<T> {
    /// The variable of differentiation at `value`: its derivative is 1.
    pub const fn variable(value: T) -> Dual<T> {
        Dual::new(value, T::ONE)
    }

    /// A constant: its derivative is 0.
    pub const fn constant(value: T) -> Dual<T> {
        Dual::new(value, T::ZERO)
    }
}

impl<T: Scalar> From<T> for Dual<T> {
    fn from(value: T) -> Dual<T> {
        Dual::constant(value)
    }
}

impl<T: Scalar> Add for Dual<T> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Dual::new(self.re + other.re, self.eps + other.eps)
    }
}

impl<T: Scalar> Sub for Dual<T> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Dual::new(self.re - other.re, self.eps - other.eps)
    }
}

impl<T: Scalar> Mul for Dual<T> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let eps = self.re * other.eps + self.eps * other.re;
        Dual::new(self.re * other.re, eps)
    }
}

impl<T: Field> Div for Dual<T> {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let re = self.re / other.re;
        Dual::new(re, (self.eps - re * other.eps) / other.re)
    }
}

impl<T: Scalar> Neg for Dual<T> {
    type Output = Self;
    fn neg(self) -> Self {
        Dual::new(-self.re, -self.eps)
    }
}

impl<T: Scalar> AddAssign for Dual<T> {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl<T: Scalar> SubAssign for Dual<T> {
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}

impl<T: Scalar> MulAssign for Dual<T> {
    fn mul_assign(&mut self, other: Self) {
        *self = *self * other;
    }
}

impl<T: Field> DivAssign for Dual<T> {
    fn div_assign(&mut self, other: Self) {
        *self = *self / other;
    }
}

impl<T: Scalar> Scalar for Dual<T> {
    const ZERO: Self = Dual::constant(T::ZERO);
    const ONE: Self = Dual::constant(T::ONE);
    const HALF: Option<Self> = match T::HALF {
        Some(half) => Some(Dual::constant(half)),
        None => None,
    };

    fn from_integer(n: i64) -> Self {
        Dual::constant(T::from_integer(n))
    }
}

impl<T: Field> Field for Dual<T> {
    fn is_invertible(self) -> bool {
        self.re.is_invertible()
    }

    fn from_ratio(numerator: i64, denominator: i64) -> Self {
        Dual::constant(T::from_ratio(numerator, denominator))
    }

    fn negligible_beside(coefficients: impl Iterator<Item = Self>) -> Self {
        Dual::constant(T::negligible_beside(coefficients.map(|x| x.re)))
    }

    fn is_within(self, bound: Self) -> bool {
        self.re.is_within(bound.re)
    }
}

/// `slope` times `eps`, and zero where `eps` is zero, however large the slope.
fn chain<T: Real>(slope: T, eps: T) -> T {
    eps.abs().select_le(T::ZERO, T::ZERO, slope * eps)
}

impl<T: Real> Real for Dual<T> {
    const PI: Self = Dual::constant(T::PI);
    const EPSILON: Self = Dual::constant(T::EPSILON);

    fn from_f64(value: f64) -> Self {
        Dual::constant(T::from_f64(value))
    }

    fn at_value(self, value: Self) -> Self {
        Dual::new(self.re.at_value(value.re), self.eps)
    }

    fn abs(self) -> Self {
        let eps = self.re.select_le(T::ZERO, -self.eps, self.eps);
        Dual::new(self.re.abs(), eps)
    }

    fn sqrt(self) -> Self {
        let root = self.re.sqrt();
        Dual::new(root, chain(T::ONE / (root + root), self.eps))
    }

    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = self.re.sin_cos();
        (
            Dual::new(sin, chain(cos, self.eps)),
            Dual::new(cos, chain(-sin, self.eps)),
        )
    }

    fn atan2(self, x: Self) -> Self {
        let radius_squared = x.re * x.re + self.re * self.re;
        let turn = x.re * self.eps - self.re * x.eps;
        let eps = chain(T::ONE / radius_squared, turn);
        Dual::new(self.re.atan2(x.re), eps)
    }

    fn exp(self) -> Self {
        let exp = self.re.exp();
        Dual::new(exp, chain(exp, self.eps))
    }

    fn ln(self) -> Self {
        Dual::new(self.re.ln(), chain(T::ONE / self.re, self.eps))
    }

    fn cosh_sinhc(self) -> (Self, Self) {
        let (c, s, slope) = self.re.cosh_sinhc_slope();
        (
            Dual::new(c, chain(s * T::from_ratio(1, 2), self.eps)),
            Dual::new(s, chain(slope, self.eps)),
        )
    }

    fn log_factor(self, square: Self) -> Option<Self> {
        let (factor, slope) = self.re.log_factor_slope(square.re)?;
        Some(Dual::new(factor, chain(slope, self.eps)))
    }

    fn is_finite(self) -> bool {
        self.re.is_finite() && self.eps.is_finite()
    }

    fn all_le(self, other: Self) -> bool {
        self.re.all_le(other.re)
    }

    fn select_le(self, bound: Self, then: Self, otherwise: Self) -> Self {
        Dual::new(
            self.re.select_le(bound.re, then.re, otherwise.re),
            self.re.select_le(bound.re, then.eps, otherwise.eps),
        )
    }
}
