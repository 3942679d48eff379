//! Study numbers p + qV: scalars and the multiples of one four-vector, whose square is a number.
//!
//! In up to five dimensions every self-reverse even element is one, so functions of a bivector
//! or of a versor are functions of a Study number times a bivector. They are complex numbers
//! for V² < 0, dual numbers for V² = 0 and pairs of numbers for V² > 0; the formulas here need
//! not know which.

use core::ops::{Add, Mul};

use crate::{Computation, Real, Scalar};

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
    #[inline(always)]
    pub fn with(self, scalar: T, fourth: T) -> Self {
        Study {
            scalar,
            fourth,
            ..self
        }
    }

    /// A real number over the same V.
    #[inline(always)]
    pub fn real(self, scalar: T) -> Self {
        self.with(scalar, T::ZERO)
    }

    /// Both parts times a number.
    #[inline(always)]
    pub fn scaled(self, factor: T) -> Self {
        self.with(self.scalar * factor, self.fourth * factor)
    }

    /// The number plus a real one.
    #[inline(always)]
    pub fn plus(self, scalar: T) -> Self {
        self.with(self.scalar + scalar, self.fourth)
    }

    /// p² − q² V², the product with the conjugate p − qV.
    #[inline(always)]
    pub fn determinant(self) -> T {
        self.scalar * self.scalar - self.fourth * self.fourth * self.square
    }
}

impl<T: Scalar> Add for Study<T> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        self.with(self.scalar + other.scalar, self.fourth + other.fourth)
    }
}

impl<T: Scalar> Mul for Study<T> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        self.with(
            self.scalar * other.scalar + self.fourth * other.fourth * self.square,
            self.scalar * other.fourth + self.fourth * other.scalar,
        )
    }
}

impl<T: Real> Study<T> {
    /// The inverse (p − qV)/(p² − q² V²); non-finite where there is none.
    #[inline(always)]
    pub fn inverse(self) -> Self {
        let factor = T::ONE / self.determinant();
        self.with(self.scalar * factor, -self.fourth * factor)
    }

    /// The square root with positive real part, (s + |s|)/√(2(p + |s|)) with
    /// |s| = √(p² − q² V²); not finite where there is none.
    #[inline(always)]
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
    #[inline(always)]
    pub fn select_le(self, value: T, bound: T, other: Self) -> Self {
        self.with(
            value.select_le(bound, self.scalar, other.scalar),
            value.select_le(bound, self.fourth, other.fourth),
        )
    }

    /// The entire functions C = cosh √s and S = sinh √s / √s of s = a + W, W² = w, so that
    /// `exp B = C(B²) + S(B²) B`.
    ///
    /// Three forms, each where it loses no digits. From the squares x, y of the two blades,
    /// x + y = a and 4xy = w: C = C(x)C(y) + S(x)S(y) W/2. Where these are alike, from
    /// λ = a ± √w, which then are not. Where both are small, as power series; so null, nearly null
    /// and isoclinic arguments are like all others.
    ///
    /// Cost: two evaluations of C and S, or 22 products of Study numbers.
    #[cfg_attr(all(feature = "inlined", not(debug_assertions)), inline(always))]
    pub fn cosh_sinhc(a: T, w: T) -> (Self, Self) {
        let square = Study {
            scalar: a,
            fourth: T::ONE,
            square: w,
        };
        let radicand = a * a - w;
        let (apart, quarter) = (T::ONE, T::from_ratio(1, 4));
        if apart.all_le(radicand) {
            return square.by_blades(radicand);
        }
        if radicand.all_le(apart) {
            if quarter.all_le(w) {
                return square.by_turns();
            }
            if w.all_le(quarter) {
                return square.by_series();
            }
        }
        T::outlined(ByAllForms(square, radicand))
    }

    /// C and S of lanes that take different forms, and of what is not a number.
    #[cfg_attr(all(feature = "inlined", not(debug_assertions)), inline(always))]
    fn by_all_forms(self, radicand: T) -> (Self, Self) {
        let (apart, quarter) = (T::ONE, T::from_ratio(1, 4));
        let (square, w) = (self, self.square);
        let (blades, turns) = (square.by_blades(radicand), square.by_turns());
        let series = square.by_series();
        let near = (
            series.0.select_le(w, quarter, turns.0),
            series.1.select_le(w, quarter, turns.1),
        );
        (
            blades.0.select_le(apart, radicand, near.0),
            blades.1.select_le(apart, radicand, near.1),
        )
    }

    /// C and S from the squares x, y of two commuting blades that are not alike.
    #[cfg_attr(all(feature = "inlined", not(debug_assertions)), inline(always))]
    fn by_blades(self, radicand: T) -> (Self, Self) {
        let root = radicand.sqrt();
        let half = T::from_ratio(1, 2);
        // The square that is a sum; the other one follows from the product.
        let x = (self.scalar + self.scalar.select_le(T::ZERO, -root, root)) * half;
        let y = self.square * T::from_ratio(1, 4) / x;
        let ((cosh_x, sinhc_x), (cosh_y, sinhc_y)) = (x.cosh_sinhc(), y.cosh_sinhc());
        let (one, other) = (cosh_x * sinhc_y, sinhc_x * cosh_y);
        let factor = T::ONE / (x - y);
        (
            self.with(cosh_x * cosh_y, sinhc_x * sinhc_y * half),
            self.with(
                (x * other - y * one) * factor,
                (one - other) * half * factor,
            ),
        )
    }

    /// C and S from the components a ± √w, which are not alike.
    #[cfg_attr(all(feature = "inlined", not(debug_assertions)), inline(always))]
    fn by_turns(self) -> (Self, Self) {
        let root = self.square.sqrt();
        let half = T::from_ratio(1, 2);
        let (plus, minus) = (
            (self.scalar + root).cosh_sinhc(),
            (self.scalar - root).cosh_sinhc(),
        );
        let cosh = self.with((plus.0 + minus.0) * half, (plus.0 - minus.0) * half / root);
        let sinhc = self.with((plus.1 + minus.1) * half, (plus.1 - minus.1) * half / root);
        (cosh, sinhc)
    }

    /// C and S as power series, for |a|, |w| up to 5/4.
    #[cfg_attr(all(feature = "inlined", not(debug_assertions)), inline(always))]
    fn by_series(self) -> (Self, Self) {
        (self.polynomial(&COSH), self.polynomial(&SINHC))
    }

    /// The polynomial with these coefficients, the constant one first: even and odd powers side by
    /// side, so that no product waits for all those before it.
    #[cfg_attr(not(all(feature = "inlined", not(debug_assertions))), inline)]
    #[cfg_attr(all(feature = "inlined", not(debug_assertions)), inline(always))]
    fn polynomial<const N: usize>(self, coefficients: &[f64; N]) -> Self {
        let square = self * self;
        // Loops, because lanes want no closure: it would not be inlined.
        let mut sums = [self.real(T::ZERO); 2];
        for (parity, sum) in sums.iter_mut().enumerate() {
            for coefficient in coefficients.iter().skip(parity).step_by(2).rev() {
                *sum = (*sum * square).plus(T::from_f64(*coefficient));
            }
        }
        let [even, odd] = sums;
        even + self * odd
    }

    /// The function z / sinh z of `self` = cosh z, given the square root of (1 + cosh z)/2,
    /// which is cosh(z/2): the factor for which `log(c + A) = f A`.
    ///
    /// The argument is halved until it is small, f(c) = f(c′)/c′ with c′ = √((1 + c)/2), and
    /// the rest is a power series in 1 − c′.
    ///
    /// Cost: 20 products of Study numbers, and for each halving a product and a square root.
    #[cfg_attr(all(feature = "inlined", not(debug_assertions)), inline(always))]
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
        let distance = cosh.scaled(-T::ONE).plus(T::ONE);
        distance.polynomial(&ARC) * product.inverse()
    }
}

/// Evaluates C and S for lanes that take different forms.
struct ByAllForms<T>(Study<T>, T);

impl<T: Real> Computation for ByAllForms<T> {
    type Output = (Study<T>, Study<T>);

    #[cfg_attr(all(feature = "inlined", not(debug_assertions)), inline(always))]
    fn run(self) -> Self::Output {
        self.0.by_all_forms(self.1)
    }
}

/// Coefficients 1/(2n)! of cosh √s.
const COSH: [f64; 13] = reciprocal_factorials(0);
/// Coefficients 1/(2n+1)! of sinh √s / √s.
const SINHC: [f64; 13] = reciprocal_factorials(1);

/// Reciprocals of the factorials of `first`, `first` + 2, …; for |s| ≤ 5/2 the first one left out
/// counts 2·10⁻¹⁹.
const fn reciprocal_factorials(first: u64) -> [f64; 13] {
    let mut coefficients = [1.0; 13];
    let mut index = 1;
    while index < coefficients.len() {
        let n = 2 * index as u64 + first;
        coefficients[index] = coefficients[index - 1] / ((n - 1) * n) as f64;
        index += 1;
    }
    coefficients
}

/// Coefficients n!/(2n+1)!! of θ/sin θ in powers of 1 − cos θ, of which the first one left out
/// counts 10⁻¹⁷ for 1/4.
const ARC: [f64; 18] = {
    let mut coefficients = [1.0; 18];
    let mut n = 1;
    while n < coefficients.len() {
        coefficients[n] = coefficients[n - 1] * n as f64 / (2 * n + 1) as f64;
        n += 1;
    }
    coefficients
};
/// Halvings that bring every finite hyperbolic cosine near one.
const LARGEST_HALVINGS: u32 = 24;
