//! Conversions and small steps shared by all generated types; generated code calls them.

mod narrowing;
mod places;

use alloc::format;
use core::fmt;

pub(crate) use narrowing::largest;
pub use narrowing::{Narrowing, narrow, try_narrow};
use places::Place;
pub(crate) use places::Places;

use crate::algorithm::rounding_of;
use crate::ops::{Element, Inverse, LeftContract, RightContract, Wedge};
use crate::{Blade, Field, Real, Scalar};

/// The type of `a.project(b)`.
pub type Projection<A, B> =
    <<A as LeftContract<B>>::Output as LeftContract<<B as Inverse>::Output>>::Output;

/// The type of `a.reject(b)`.
pub type Rejection<A, B> =
    <<A as Wedge<B>>::Output as RightContract<<B as Inverse>::Output>>::Output;

/// `(a ⌋ B) B⁻¹` (2.29); the outer product is a contraction because `a ⌋ B` lies in `B`.
#[inline]
pub fn project<A, B>(a: A, b: B) -> Projection<A, B>
where
    B: Inverse + Copy,
    A: LeftContract<B>,
    A::Output: LeftContract<B::Output>,
{
    a.left_contract(b).left_contract(b.reciprocal())
}

/// `(a ∧ B) B⁻¹` (2.30); the outer product is a contraction because `B` lies in `a ∧ B`.
#[inline]
pub fn reject<A, B>(a: A, b: B) -> Rejection<A, B>
where
    B: Inverse + Copy,
    A: Wedge<B>,
    A::Output: RightContract<B::Output>,
{
    a.wedge(b).right_contract(b.reciprocal())
}

/// The part of one grade.
#[inline(always)]
pub fn grade<X: Element>(x: X, grade: u32) -> X {
    X::from_fn(|i| {
        if X::BLADES[i].0.grade() == grade {
            x.at(i)
        } else {
            X::Number::ZERO
        }
    })
}

/// The coefficients of `wide` that `Narrow` stores; the others are dropped.
#[inline(always)]
pub fn pick<Wide, Narrow>(wide: Wide) -> Narrow
where
    Wide: Element,
    Narrow: Element<Number = Wide::Number>,
    Wide::Number: Field,
{
    Narrow::from_fn(|i| {
        signed(
            Narrow::BLADES[i].1,
            Places::<Wide, Narrow>::at(i).read(&wide),
        )
    })
}

/// The blade of a field of `X`, as spelled there, as an element of a type that stores it.
#[inline(always)]
pub fn basis<X, Linear>(position: usize) -> Linear
where
    X: Element,
    Linear: Element<Number = X::Number>,
{
    let wanted = X::BLADES.get(position);
    Linear::from_fn(|i| {
        let (blade, sign) = Linear::BLADES[i];
        match wanted {
            Some((own, spelled)) if *own == blade => signed(sign * spelled, X::Number::ONE),
            _ => X::Number::ZERO,
        }
    })
}

/// The coefficients of `x` that `Narrow` stores, each times a factor; of the others, the factor
/// is known to make the fixed ones of `Narrow`.
#[inline(always)]
pub fn multiple<X, Narrow>(x: X, factor: X::Number) -> Narrow
where
    X: Element,
    Narrow: Element<Number = X::Number>,
    X::Number: Field,
{
    Narrow::from_fn(|i| {
        let (blade, sign) = Narrow::BLADES[i];
        signed(sign, coefficient(&x, blade)) * factor
    })
}

/// The coefficient of a blade in increasing order, stored or fixed.
#[inline(always)]
pub(crate) fn coefficient<X: Element>(x: &X, blade: Blade) -> X::Number
where
    X::Number: Field,
{
    Place::of::<X>(blade).read(x)
}

/// The image of a versor application from the unrestricted `V x Ṽ`: only grades that the
/// operand has, the odd ones negated for an odd versor.
#[inline]
pub fn image<Wide, Operand, Narrow>(wide: Wide, odd: bool) -> Narrow
where
    Wide: Element,
    Operand: Element,
    Narrow: Element<Number = Wide::Number>,
    Wide::Number: Field,
{
    Narrow::from_fn(|i| {
        let (blade, sign) = Narrow::BLADES[i];
        let same = |other: &Blade| other.grade() == blade.grade();
        let stored = Operand::BLADES.iter().any(|(other, _)| same(other));
        if !stored && !Operand::FIXED.iter().any(|(other, ..)| same(other)) {
            return Wide::Number::ZERO;
        }
        let value = signed(sign, coefficient(&wide, blade));
        if odd && blade.grade() % 2 == 1 {
            -value
        } else {
            value
        }
    })
}

#[inline(always)]
pub(crate) fn signed<T: Scalar>(sign: i8, value: T) -> T {
    if sign < 0 { -value } else { value }
}

/// The answer of `Index` for a blade that a type does not store.
///
/// # Panics
/// Always, as indexing beyond a collection does.
#[cold]
pub fn not_stored(name: &str, blade: Blade) -> ! {
    panic!(
        "`{name}` does not store the blade {:#b}; `get` answers with an `Option`",
        blade.mask()
    )
}

/// Writes an element as `1 - 2.5 e12`: coefficients of zero are left out, ones are implied where
/// no precision is asked for.
pub fn display<T: Scalar + fmt::Display>(
    f: &mut fmt::Formatter<'_>,
    fixed: &[(&str, i64, i64)],
    free: &[(&str, T)],
) -> fmt::Result {
    let mut first = true;
    for (label, numerator, denominator) in fixed {
        let number = match denominator {
            1 => format!("{numerator}"),
            _ => format!("{numerator}/{denominator}"),
        };
        term(
            f,
            &mut first,
            &number,
            label,
            (*numerator, *denominator) == (1, 1),
        )?;
    }
    for (label, value) in free {
        if *value == T::ZERO {
            continue;
        }
        let implied = *value == T::ONE && f.precision().is_none();
        let number = match f.precision() {
            Some(digits) => format!("{value:.digits$}"),
            None => format!("{value}"),
        };
        term(f, &mut first, &number, label, implied)?;
    }
    if first {
        fmt::Display::fmt(&T::ZERO, f)
    } else {
        Ok(())
    }
}

/// One term with the sign that joins it to those before.
fn term(
    f: &mut fmt::Formatter<'_>,
    first: &mut bool,
    number: &str,
    label: &str,
    implied: bool,
) -> fmt::Result {
    let (sign, size) = match (core::mem::take(first), number.strip_prefix('-')) {
        (true, _) => ("", number),
        (false, Some(size)) => (" - ", size),
        (false, None) => (" + ", number),
    };
    match (label, implied) {
        ("1", _) => write!(f, "{sign}{size}"),
        (_, true) => write!(f, "{sign}{label}"),
        (_, false) => write!(f, "{sign}{size} {label}"),
    }
}

/// The norm of `R = c + X` from `c` and the scalar X², with X² handed through; `None` where
/// R R̃ is not a positive number.
///
/// It is 1 where R R̃ is 1 up to the rounding of its terms: of a large boost, R R̃ is a small
/// difference of large numbers and says less than that.
#[inline]
pub fn polar<T: Real>(scalar: T, square: T) -> Option<(T, T)> {
    let norm_squared = scalar * scalar - square;
    let rounding = rounding_of(scalar * scalar + square.abs());
    let distance = (norm_squared - T::ONE).abs();
    let norm_squared = distance.select_le(rounding, norm_squared.at_value(T::ONE), norm_squared);
    let positive = T::ZERO.all_le(norm_squared) && norm_squared.is_invertible();
    (positive && rounding.is_finite()).then(|| (norm_squared.sqrt(), square))
}

/// The factor `f` for which `log R = f X` is the principal logarithm of the versor `R = c + X`
/// over its norm, from `c` and the scalar X²; `None` where there is none. That of a unit versor
/// takes no norm.
#[inline]
pub fn logarithm_factor<T: Real>(scalar: T, square: T) -> Option<T> {
    let norm_squared = scalar * scalar - square;
    let is_unit = (norm_squared - T::ONE).abs().all_le(rounding_of(T::ONE));
    if is_unit && norm_squared.at_value(T::ONE) == T::ONE {
        return scalar.log_factor(square);
    }
    factor_over_norm(scalar, square)
}

#[inline(never)]
fn factor_over_norm<T: Real>(scalar: T, square: T) -> Option<T> {
    let (norm, square) = polar(scalar, square)?;
    let factor = (scalar / norm).log_factor(square / (norm * norm))?;
    Some(factor / norm)
}

/// The scalar part of √R and the factor of X in it, for `R = c + X`: `(R + |R|) f` with
/// f = 1/√(2(c + |R|)).
#[inline]
pub fn half<T: Real>(scalar: T, square: T) -> Option<(T, T)> {
    let (norm, square) = polar(scalar, square)?;
    // c + |R| cancels for negative c; (c + |R|)(|R| − c) = −X² does not.
    let sum = if scalar.all_le(T::ZERO) {
        -square / (norm - scalar)
    } else {
        scalar + norm
    };
    let positive = T::ZERO.all_le(sum) && sum.is_invertible() && sum.is_finite();
    positive.then(|| {
        let factor = T::ONE / (sum + sum).sqrt();
        (sum * factor, factor)
    })
}
