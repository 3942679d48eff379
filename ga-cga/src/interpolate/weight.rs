//! How elements are taken out of their weight, and put back with a weight that grows evenly.

use ga_core::{Element, Field, Real, Scalar};

use super::NoPath;
use crate::classify::range::{largest, power_of_two};

/// The element over a power of two that brings its largest coefficient near 1, and that power.
/// What has a fixed coefficient stays as it is.
pub(super) fn in_range<X>(x: X) -> Result<(X, X::Number), NoPath>
where
    X: Element<Number: Real>,
{
    let size = largest(&x).ok_or(NoPath::NotFinite)?;
    if !X::FIXED.is_empty() {
        return Ok((x, X::Number::ONE));
    }
    let power = power_of_two(size);
    Ok((X::from_fn(|position| x.at(position) / power), power))
}

/// Two elements as [`in_range`] leaves them, neither of them zero.
pub(super) fn both_in_range<X>(from: X, to: X) -> Result<[X; 2], NoPath>
where
    X: Element<Number: Real>,
{
    let ((from, _), (to, _)) = (in_range(from)?, in_range(to)?);
    let zero = |x: &X| X::FIXED.is_empty() && largest(x) == Some(X::Number::ZERO);
    if zero(&from) || zero(&to) {
        return Err(NoPath::Null);
    }
    Ok([from, to])
}

/// The element with its coefficients multiplied, where it has a weight that can be.
pub(super) fn scaled<X: Element>(x: X, factor: X::Number) -> X {
    if !X::FIXED.is_empty() {
        return x;
    }
    X::from_fn(|position| x.at(position) * factor)
}

/// The weight k e^{gt} along a path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Weight<T> {
    /// The weight at the start, against an element near 1.
    pub start: T,
    /// The logarithm of the factor that it grows by.
    pub growth: T,
}

impl<T: Real> Weight<T> {
    /// The weight k that stays what it is.
    pub fn constant(start: T) -> Self {
        Weight {
            start,
            growth: T::ZERO,
        }
    }

    /// The weight that grows from its start to a factor times another one.
    ///
    /// # Errors
    /// [`NoPath::NotFinite`] where the one is out of the other's range.
    pub fn grown(self, factor: T, end: T) -> Result<Self, NoPath> {
        let whole = factor * (end / self.start);
        let growth = whole.ln();
        // Both ends are finite, but their quotient need not be.
        let usable = whole.is_invertible() && growth.is_finite();
        let start = self.start;
        usable
            .then_some(Weight { start, growth })
            .ok_or(NoPath::NotFinite)
    }

    /// The weight at t.
    pub fn at(self, t: T) -> T {
        self.start * (self.growth * t).exp()
    }
}

/// The element, if all its coefficients are finite.
pub(super) fn finite<X>(x: X) -> Result<X, NoPath>
where
    X: Element<Number: Real>,
{
    largest(&x).map(|_| x).ok_or(NoPath::NotFinite)
}

/// The number that an element near 1 must be multiplied by to be the other one, by least squares.
///
/// # Errors
/// [`NoPath::Imprecise`] where it is not a multiple to within rounding.
pub(super) fn factor<X>(image: X, target: X) -> Result<X::Number, NoPath>
where
    X: Element<Number: Real>,
{
    let zero = X::Number::ZERO;
    let sum = |term: &dyn Fn(usize) -> X::Number| {
        (0..X::BLADES.len()).fold(zero, |sum, position| sum + term(position))
    };
    let own = sum(&|i| image.at(i) * image.at(i));
    let factor = match X::FIXED.is_empty() {
        true => sum(&|i| image.at(i) * target.at(i)) / own,
        false => X::Number::ONE,
    };
    // What rounding does to a way that is nearly not unique is of the order of the root.
    let tolerance = X::Number::EPSILON.sqrt() * X::Number::from_integer(16);
    let off = sum(&|i| (image.at(i) * factor - target.at(i)).abs());
    let size = sum(&|i| target.at(i).abs()) + X::Number::ONE;
    if off.all_le(size * tolerance) && factor.is_invertible() {
        Ok(factor)
    } else {
        Err(NoPath::Imprecise)
    }
}
