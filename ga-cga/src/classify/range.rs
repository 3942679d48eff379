//! How coefficients are kept in the middle of the range of their number type.

use ga_core::{Element, Field, Real, Scalar};

/// The larger of two numbers, lane by lane.
pub(crate) fn larger<T: Real>(a: T, b: T) -> T {
    a.select_le(b, b, a)
}

/// The largest absolute value of a coefficient; `None` if one is not finite.
pub(crate) fn largest<X>(x: &X) -> Option<X::Number>
where
    X: Element<Number: Real>,
{
    let mut largest = X::Number::ZERO;
    for position in 0..X::BLADES.len() {
        let size = x.at(position).abs();
        if !size.is_finite() {
            return None;
        }
        largest = larger(largest, size);
    }
    Some(largest)
}

/// The element times a power of two that brings its largest coefficient near 1, so that
/// products of coefficients neither overflow nor vanish; nothing is rounded. `None` for zero and
/// for elements that are not finite.
pub(crate) fn within_range<X>(x: X) -> Option<X>
where
    X: Element<Number: Real>,
{
    let step = X::Number::from_integer(1 << 16);
    let bound = step;
    let mut x = x;
    let mut size = largest(&x)?;
    if size == X::Number::ZERO {
        return None;
    }
    let scaled = |x: X, factor: X::Number| X::from_fn(|position| x.at(position) * factor);
    while !size.all_le(bound) {
        let down = X::Number::from_ratio(1, 1 << 16);
        (x, size) = (scaled(x, down), size * down);
    }
    while (size * bound).all_le(X::Number::ONE) {
        (x, size) = (scaled(x, step), size * step);
    }
    Some(x)
}

/// The root of the sum of the squared coefficients, without overflow; infinite where the length
/// itself is out of range, and where a coefficient is not a number.
pub(crate) fn length<X>(x: X) -> X::Number
where
    X: Element<Number: Real>,
{
    let infinite = X::Number::from_f64(f64::INFINITY);
    let Some(largest) = largest(&x) else {
        return infinite;
    };
    let zero = X::Number::ZERO;
    let divisor = largest.select_le(zero, X::Number::ONE, largest);
    let mut sum = zero;
    for position in 0..X::BLADES.len() {
        let ratio = x.at(position) / divisor;
        sum += ratio * ratio;
    }
    sum.sqrt() * divisor
}

/// The largest power of two that is not larger than a positive number, so that dividing by it
/// rounds nothing; 1 for zero and for what is not finite. On lanes one that fits the largest.
pub(crate) fn power_of_two<T: Real>(size: T) -> T {
    if !size.is_invertible() {
        return T::ONE;
    }
    let mut power = T::ONE;
    for step in [1_i64 << 16, 2] {
        let (up, down) = (T::from_integer(step), T::from_ratio(1, step));
        while !size.all_le(power * up) {
            power *= up;
        }
        while (size * up).all_le(power) {
            power *= down;
        }
    }
    power
}
