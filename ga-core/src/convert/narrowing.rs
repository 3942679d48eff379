//! When an element is one of a narrower type: which coefficients are negligible, and which are in
//! the way.

use core::fmt;

use super::{coefficient, pick, signed};
use crate::ops::Element;
use crate::{Blade, Field, Real, Scalar};

/// A narrowing conversion would drop a coefficient that is not negligible, the value of a fixed
/// coefficient is another one, or an element is not null that has to be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Narrowing {
    /// The blade whose coefficient is in the way.
    pub blade: Blade,
    /// Whether it is a coefficient of the square, which the narrower type, declared `#[null]`,
    /// wants to vanish.
    pub square: bool,
}

impl Narrowing {
    /// The size against the largest coefficient up to which `TryFrom` neglects a coefficient of
    /// floating-point numbers. Exact numbers neglect nothing.
    pub const TOLERANCE: f64 = 1e-6;
}

impl fmt::Display for Narrowing {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mask = self.blade.mask();
        match self.square {
            false => write!(
                f,
                "the coefficient of blade {mask:#b} does not fit the narrower type; convert to a \
                 type that stores it, or narrow with a larger tolerance"
            ),
            true => write!(
                f,
                "the square has a coefficient of blade {mask:#b}, but values of the narrower type \
                 square to 0; convert to a type without `#[null]`, or narrow with a larger \
                 tolerance"
            ),
        }
    }
}

impl core::error::Error for Narrowing {}

/// The narrower element, if all coefficients it does not store are within `tolerance` times
/// the largest coefficient of zero, or of their fixed value. Nothing is, where the largest one
/// is not finite.
///
/// # Errors
/// [`Narrowing`] with the first blade that is in the way.
pub fn narrow<Wide, Narrow>(wide: Wide, tolerance: Wide::Number) -> Result<Narrow, Narrowing>
where
    Wide: Element<Number: Real>,
    Narrow: Element<Number = Wide::Number>,
{
    let bound = largest(coefficients(&wide), Wide::Number::abs) * tolerance;
    let narrow = narrow_where(wide, |difference| {
        bound.is_finite() && difference.abs().all_le(bound)
    })?;
    null_where(narrow, |terms, sum| {
        let bound = largest(terms, Wide::Number::abs) * tolerance;
        bound.is_finite() && sum.abs().all_le(bound)
    })
}

/// The narrower element, if all coefficients it does not store are negligible in their own kind
/// of numbers: zero or their fixed value, up to [`Narrowing::TOLERANCE`] where numbers round.
///
/// # Errors
/// [`Narrowing`] with the first blade that is in the way.
pub fn try_narrow<Wide, Narrow>(wide: Wide) -> Result<Narrow, Narrowing>
where
    Wide: Element<Number: Field>,
    Narrow: Element<Number = Wide::Number>,
{
    let bound = Wide::Number::negligible_beside(coefficients(&wide));
    let narrow = narrow_where(wide, |difference| difference.is_within(bound))?;
    null_where(narrow, |terms, sum| {
        sum.is_within(Wide::Number::negligible_beside(terms))
    })
}

/// The element, if all that vanishes for the values of its type is negligible beside its terms.
fn null_where<X: Element<Number: Field>>(
    x: X,
    is_negligible: impl Fn(&mut dyn Iterator<Item = X::Number>, X::Number) -> bool,
) -> Result<X, Narrowing> {
    for (blade, form) in X::NULL {
        let value = |position: usize| match position < X::BLADES.len() {
            true => x.at(position),
            false => X::Number::ONE,
        };
        let terms = form.iter().map(|(first, second, numerator, denominator)| {
            let factor = X::Number::from_ratio(*numerator, *denominator);
            value(*first) * value(*second) * factor
        });
        let sum = terms.clone().fold(X::Number::ZERO, |sum, term| sum + term);
        if !is_negligible(&mut terms.clone(), sum) {
            return Err(Narrowing {
                blade: *blade,
                square: true,
            });
        }
    }
    Ok(x)
}

fn coefficients<X: Element>(x: &X) -> impl Iterator<Item = X::Number> {
    (0..X::BLADES.len()).map(|i| x.at(i))
}

/// The size of the largest number, in every lane; not a number where one is not.
pub(crate) fn largest<T: Field>(numbers: impl Iterator<Item = T>, size: impl Fn(T) -> T) -> T {
    let half = T::from_ratio(1, 2);
    numbers.fold(T::ZERO, |bound, number| {
        // Halved first, so that the sum does not overflow.
        let (bound, number) = (bound * half, size(number) * half);
        bound + number + size(bound - number)
    })
}

/// The coefficient of a blade is in the way.
fn refused(blade: Blade) -> Narrowing {
    Narrowing {
        blade,
        square: false,
    }
}

/// The narrower element, if every coefficient that it does not store differs negligibly from
/// zero or from its fixed value.
fn narrow_where<Wide, Narrow>(
    wide: Wide,
    is_negligible: impl Fn(Wide::Number) -> bool,
) -> Result<Narrow, Narrowing>
where
    Wide: Element<Number: Field>,
    Narrow: Element<Number = Wide::Number>,
{
    for (i, (blade, sign)) in Wide::BLADES.iter().enumerate() {
        if Narrow::BLADES.iter().any(|(stored, _)| stored == blade) {
            continue;
        }
        let fixed = Narrow::FIXED.iter().find(|(stored, ..)| stored == blade);
        let expected = fixed.map_or(Wide::Number::ZERO, |(_, own, numerator, denominator)| {
            signed(
                own * sign,
                Wide::Number::from_ratio(*numerator, *denominator),
            )
        });
        if !is_negligible(wide.at(i) - expected) {
            return Err(refused(*blade));
        }
    }
    // What the narrow type fixes and the wide one does not store, the wide one has to fix at
    // the same value; absent coefficients are zero.
    for (blade, sign, numerator, denominator) in Narrow::FIXED {
        if Wide::BLADES.iter().any(|(stored, _)| stored == blade) {
            continue;
        }
        let own = signed(*sign, Wide::Number::from_ratio(*numerator, *denominator));
        if coefficient(&wide, *blade) != own {
            return Err(refused(*blade));
        }
    }
    // What the wide type fixes has to have a place in the narrow one.
    let placed = |blade: &Blade| {
        Narrow::BLADES.iter().any(|(stored, _)| stored == blade)
            || Narrow::FIXED.iter().any(|(fixed, ..)| fixed == blade)
    };
    if let Some((blade, ..)) = Wide::FIXED.iter().find(|(blade, ..)| !placed(blade)) {
        return Err(refused(*blade));
    }
    Ok(pick(wide))
}
