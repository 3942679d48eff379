//! Study numbers p + qV: scalars and the multiples of one four-vector, whose square is a number.
//!
//! In up to five dimensions every self-reverse even element is one, so functions of a bivector
//! or of a versor are functions of a Study number times a bivector. They are complex numbers
//! for V² < 0, dual numbers for V² = 0 and pairs of numbers for V² > 0; the formulas here need
//! not know which.

use core::ops::{Add, Mul};

use crate::{Real, Scalar};

/// A Study number `scalar + fourth V`, with the square of the four-vector V.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Study<T> {
    /// The part of grade 0.
    pub scalar: T,
    /// The multiple of V.
    pub fourth: T,
    /// V².
    pub square: T,
}

impl<T: Scalar> Study<T> {
    /// The number with these parts over the same V.
    pub fn with(self, scalar: T, fourth: T) -> Self {
        Study {
            scalar,
            fourth,
            ..self
        }
    }

    /// A real number over the same V.
    pub fn real(self, scalar: T) -> Self {
        self.with(scalar, T::ZERO)
    }

    /// Both parts times a number.
    pub fn scaled(self, factor: T) -> Self {
        self.with(self.scalar * factor, self.fourth * factor)
    }

    /// The number plus a real one.
    pub fn plus(self, scalar: T) -> Self {
        self.with(self.scalar + scalar, self.fourth)
    }

    /// p² − q² V², the product with the conjugate p − qV.
    pub fn determinant(self) -> T {
        self.scalar * self.scalar - self.fourth * self.fourth * self.square
    }
}

impl<T: Scalar> Add for Study<T> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        self.with(self.scalar + other.scalar, self.fourth + other.fourth)
    }
}

impl<T: Scalar> Mul for Study<T> {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        self.with(
            self.scalar * other.scalar + self.fourth * other.fourth * self.square,
            self.scalar * other.fourth + self.fourth * other.scalar,
        )
    }
}

impl<T: Real> Study<T> {
    /// The inverse (p − qV)/(p² − q² V²); non-finite where there is none.
    pub fn inverse(self) -> Self {
        let factor = T::ONE / self.determinant();
        self.with(self.scalar * factor, -self.fourth * factor)
    }

    /// The square root with positive real part, (s + |s|)/√(2(p + |s|)) with
    /// |s| = √(p² − q² V²); not finite where there is none.
    pub fn sqrt(self) -> Self {
        let norm = self.determinant().sqrt();
        // p + |s| cancels for negative p; (p + |s|)(|s| − p) = −q² V² does not.
        let conjugate = -self.fourth * self.fourth * self.square / (norm - self.scalar);
        let sum = self
            .scalar
            .select_le(T::ZERO, conjugate, self.scalar + norm);
        let factor = T::ONE / (sum + sum).sqrt();
        self.with(sum * factor, self.fourth * factor)
    }

    /// Lane by lane: `self` where `value ≤ bound`, `other` elsewhere.
    pub fn select_le(self, value: T, bound: T, other: Self) -> Self {
        self.with(
            value.select_le(bound, self.scalar, other.scalar),
            value.select_le(bound, self.fourth, other.fourth),
        )
    }

    /// The entire functions C = cosh √s and S = sinh √s / √s of s = p + qV, so that
    /// `exp B = C(B²) + S(B²) B`.
    ///
    /// The argument is divided by four until it is small, both power series are summed, and
    /// the results follow by C(4s) − 1 = 2(C − 1)(C + 1) and S(4s) = S C. There is no split into
    /// planes and no branch, so null, nearly null and isoclinic arguments are like all others.
    ///
    /// Cost: 22 products of Study numbers, and two for each division by four.
    pub fn cosh_sinhc(self) -> (Self, Self) {
        let quarter = T::from_ratio(1, 4);
        let mut argument = self;
        let mut length = T::ONE;
        let mut divisions = 0;
        // V is divided with its coefficient, so that its square does not overflow before that.
        while !(argument.scalar.abs().all_le(T::from_ratio(1, 2))
            && argument.square.abs().all_le(quarter))
            && divisions < LARGEST_EXPONENT
        {
            argument.scalar *= quarter;
            argument.square *= quarter * quarter;
            length *= quarter;
            divisions += 1;
        }
        let one = argument.real(T::ONE);
        let (mut cosh, mut sinhc) = (one, one);
        for n in (1..SERIES_TERMS).rev() {
            cosh = one + (argument * cosh).scaled(T::from_ratio(1, (2 * n + 1) * (2 * n + 2)));
            sinhc = one + (argument * sinhc).scaled(T::from_ratio(1, 2 * n * (2 * n + 1)));
        }
        let mut excess = (argument * cosh).scaled(T::from_ratio(1, 2));
        for _ in 0..divisions {
            sinhc = sinhc * excess.plus(T::ONE);
            excess = (excess * excess.plus(T::from_integer(2))).scaled(T::from_integer(2));
        }
        let back = |number: Self| self.with(number.scalar, number.fourth * length);
        (back(excess.plus(T::ONE)), back(sinhc))
    }

    /// The function z / sinh z of `self` = cosh z, given the square root of (1 + cosh z)/2,
    /// which is cosh(z/2): the factor for which `log(c + A) = f A`.
    ///
    /// The argument is halved until it is small, f(c) = f(c′)/c′ with c′ = √((1 + c)/2), and
    /// the rest is (1 − t²) artanh(t)/t with t² = tanh²(z/2).
    ///
    /// Cost: 15 products of Study numbers, and for each halving a product and a square root.
    pub fn log_factor(half: Self) -> Self {
        let one_half = T::from_ratio(1, 2);
        let mut cosh = half;
        let mut product = half;
        for _ in 0..LARGEST_HALVINGS {
            let distance = (cosh.scalar - T::ONE).abs();
            let turn = (cosh.fourth * cosh.fourth * cosh.square).abs();
            if distance.all_le(T::from_ratio(1, 8)) && turn.all_le(T::from_ratio(1, 64)) {
                break;
            }
            cosh = cosh.plus(T::ONE).scaled(one_half).sqrt();
            product = product * cosh;
        }
        let tanh_squared = cosh.plus(-T::ONE) * cosh.plus(T::ONE).inverse();
        let mut sum = half.real(T::ZERO);
        for n in (0..LOGARITHM_TERMS).rev() {
            sum = (tanh_squared * sum).plus(T::from_ratio(1, 2 * n + 1));
        }
        tanh_squared.scaled(-T::ONE).plus(T::ONE) * sum * product.inverse()
    }
}

/// Terms of the series of cosh √s and sinh √s / √s; the first left out is below 1/24!.
const SERIES_TERMS: i64 = 12;
/// Terms of the series of artanh t / t for |t²| ≤ 1/7.
const LOGARITHM_TERMS: i64 = 19;
/// Divisions by four that bring every finite number below one half.
const LARGEST_EXPONENT: u32 = 513;
/// Halvings that bring every finite hyperbolic cosine near one.
const LARGEST_HALVINGS: u32 = 24;
