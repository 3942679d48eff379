//! Logarithms and square roots of versors in any dimension: by inverse scaling and squaring.

use super::normalise::rounding_of;
use super::parts::{finite, part, scalar, sum_of_sizes, sum_of_squares};
use super::principal_root::{
    Evens, MOST_STEPS, polar_factor, principal_root, step_products, times, tolerance,
};
use super::series::{MOST_HALVINGS, MOST_TERMS, exponential};
use crate::ops::Element;
use crate::{Blade, Field, Real, Scalar, convert};

/// How many roots are taken at most: enough for translations as long as 2⁶⁴.
pub const MOST_ROOTS: usize = 64;
/// How many terms of the series of the inverse sine are summed at most.
const MOST_SINE_TERMS: usize = 64;

/// How many products [`principal_logarithm`] takes at most on a type of `blades` blades: R R̃, the
/// polar factor of R, the roots, the series of the inverse sine, and the exponential.
pub const fn logarithm_products(blades: usize) -> usize {
    let root = MOST_STEPS * step_products(blades);
    1 + (1 + MOST_ROOTS) * root + 1 + MOST_SINE_TERMS + exponential_products()
}

/// How many products [`principal_square_root`] takes at most on a type of `blades` blades: those
/// of the logarithm and of another exponential.
pub const fn square_root_products(blades: usize) -> usize {
    logarithm_products(blades) + exponential_products()
}

const fn exponential_products() -> usize {
    MOST_TERMS + MOST_HALVINGS
}

/// The principal logarithm of a versor over its norm, by inverse scaling and squaring (Higham,
/// *Functions of Matrices*, 2008, section 11.5): k square roots until the coefficients of R − 1
/// add up to no more than ½, then `log R = 2ᵏ arsinh((R − R̃)/2)` as a power series.
///
/// Its turns add up to less than π; rapidities and translations have no bound. `None` for
/// everything else: where no real logarithm exists, for −1, for turns that add up to π or more,
/// and for what is no versor. What is returned has been exponentiated, and the
/// exponential agreed with the versor: the tolerance of all comparisons is the root of the
/// distance between 1 and the next number, against the sum of the coefficients.
pub fn principal_logarithm<M, A>(versor: M) -> Option<A>
where
    M: Evens + From<A>,
    A: Element<Number = M::Number>,
{
    logarithm_of_unit(unit(versor)?.0)
}

/// The principal square root of a versor, the exponential of half of [`principal_logarithm`]
/// times the root of the norm: `None` as for that.
pub fn principal_square_root<M, A>(versor: M) -> Option<M>
where
    M: Evens + From<A>,
    A: Element<Number = M::Number>,
{
    let (unit, norm) = unit(versor)?;
    let half = M::Number::from_ratio(1, 2);
    let logarithm = M::from(logarithm_of_unit::<M, A>(unit)?);
    let root = exponential(logarithm.geometric(half));
    finite(root.geometric(norm.sqrt()))
}

/// The versor over its norm, and the norm; `None` where `R R̃` is no positive number.
///
/// A versor whose `R R̃` is 1 up to rounding is left as it is.
fn unit<M: Evens>(versor: M) -> Option<(M, M::Number)> {
    let product = times(versor, versor.reverse());
    let square = convert::coefficient(&product, Blade::SCALAR);
    let rest = sum_of_sizes(&(product - scalar(square)));
    let rounding = rounding_of(sum_of_squares(&versor));
    if !(rounding.is_finite() && square.is_finite()) {
        return None;
    }
    let deviation = (square - M::Number::ONE).abs() + rest;
    if deviation.all_le(rounding) {
        return Some((versor, M::Number::ONE));
    }
    if !(rest.all_le(square * tolerance() + rounding) && square.is_invertible()) {
        return None;
    }
    let norm = square.sqrt();
    let unit = versor.geometric(M::Number::ONE / norm);
    let exists = norm.is_finite() && norm.is_invertible();
    exists.then_some((polar_factor(finite(unit)?)?, norm))
}

fn logarithm_of_unit<M, A>(unit: M) -> Option<A>
where
    M: Evens + From<A>,
    A: Element<Number = M::Number>,
{
    let half = M::Number::from_ratio(1, 2);
    let size = |x: &M| sum_of_sizes(x);
    let mut root = unit;
    let mut roots = 0;
    while !size(&(root - scalar(M::Number::ONE))).all_le(half) {
        if roots == MOST_ROOTS {
            return None;
        }
        root = principal_root(root)?;
        roots += 1;
    }
    let mut logarithm = inverse_sine((root - root.reverse()).geometric(half));
    for _ in 0..roots {
        logarithm = logarithm + logarithm;
    }
    let bivector: A = finite(part(logarithm, 2))?;
    let whole = M::from(bivector);
    let other = size(&(logarithm - whole));
    let missed = size(&(exponential(whole) - unit));
    let agrees = other.all_le(size(&whole) * tolerance() + rounding_of(M::Number::ONE))
        && missed.all_le(size(&unit) * tolerance());
    agrees.then_some(bivector)
}

/// `arsinh y = y − y³/6 + 3y⁵/40 − …` of an element whose coefficients add up to no more than ½.
fn inverse_sine<M: Evens>(sine: M) -> M {
    let square = times(sine, sine);
    let mut power = sine;
    let mut sum = sine;
    for n in 1..=MOST_SINE_TERMS as i64 {
        power = times(power, square).geometric(M::Number::from_ratio(1 - 2 * n, 2 * n));
        let term = power.geometric(M::Number::from_ratio(1, 2 * n + 1));
        sum = sum + term;
        let negligible = sum_of_sizes(&sum) * M::Number::from_f64(1e-18);
        if sum_of_sizes(&term).all_le(negligible) {
            break;
        }
    }
    sum
}
