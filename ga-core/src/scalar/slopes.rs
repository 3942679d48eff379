//! Derivatives of the functions of rotors, from their values or as power series.

use super::Real;

/// S′ = (C − S)/(2a), given C and S at `a`; near zero by its series.
pub(super) fn sinhc_slope<T: Real>(a: T, cosh: T, sinhc: T) -> T {
    let quotient = (cosh - sinhc) / (a + a);
    a.abs().select_le(T::ONE, sinhc_series(a), quotient)
}

/// f′ = (1 − c f)/s along c² − s = 1, given f at `c` and `s`; near c = 1 by its series.
pub(super) fn log_factor_slope<T: Real>(c: T, s: T, factor: T) -> T {
    let quotient = (T::ONE - factor * c) / s;
    let by_series = (c + c) * arsinhc_series(s);
    let near = s.abs().select_le(T::from_ratio(1, 8), by_series, quotient);
    c.select_le(T::ZERO, quotient, near)
}

/// The series Σ (m+1) aᵐ/(2m+3)! of S′, for |a| ≤ 1, by the ratios of successive terms.
fn sinhc_series<T: Real>(a: T) -> T {
    let ratio = |m: i64| T::from_ratio(m + 1, m * (2 * m + 2) * (2 * m + 3));
    let sum = (1..=10)
        .rev()
        .fold(T::ONE, |sum, m| T::ONE + sum * a * ratio(m));
    sum * T::from_ratio(1, 6)
}

/// The derivative −1/6 + 3s/20 − … of arsinh √s / √s, for |s| ≤ 1/8.
fn arsinhc_series<T: Real>(s: T) -> T {
    let ratio = |n: i64| T::from_ratio(-(2 * n + 1) * (2 * n + 1), 2 * n * (2 * n + 3));
    let sum = (1..=18)
        .rev()
        .fold(T::ONE, |sum, n| T::ONE + sum * s * ratio(n));
    sum * T::from_ratio(-1, 6)
}
