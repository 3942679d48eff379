//! Elements to compute with, and when two answers are the same.

use ga_core::{Element, Real};
use ga_lanes::{Batch, Number, Target};

/// None, one, fewer than lanes, as many, one more, and several lines of the cache.
pub const LENGTHS: [usize; 9] = [0, 1, 3, 8, 15, 16, 17, 33, 100];

/// Different coefficients between −2 and 2, the same for the same seed.
pub fn elements<X: Element<Number: Real>>(len: usize, seed: u64) -> Vec<X> {
    let mut state = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1;
    let mut next = || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        X::Number::from_f64((state >> 40) as f64 / (1_u64 << 22) as f64 - 2.0)
    };
    (0..len).map(|_| X::from_fn(|_| next())).collect()
}

/// Runs a test on every target that the machine has.
pub fn on_every_target(test: impl Fn()) {
    for target in Target::ALL {
        let ran = target.scope(&test);
        assert_eq!(ran.is_some(), target.is_available());
    }
}

/// Whether two numbers are the same, or both none, or no further apart than roundings of numbers
/// of a size explain. On the portable target, where nothing is fused that is not fused for
/// single numbers too, they have to be the same.
pub fn same<F: Number + Into<f64>>(one: F, other: F, size: f64) -> bool {
    let (one, other): (f64, f64) = (one.into(), other.into());
    let roundings = if Target::current() == Target::Portable {
        0.0
    } else {
        64.0
    };
    one == other
        || one.is_nan() && other.is_nan()
        || (one - other).abs() <= roundings * <F as Real>::EPSILON.into() * size
}

/// Asserts that a batch holds these elements up to rounding.
pub fn assert_same<X>(batch: &Batch<X>, expected: &[X], operation: &str)
where
    X: Element<Number: Number + Into<f64>> + std::fmt::Debug,
{
    assert_eq!(batch.len(), expected.len(), "{operation}");
    for (index, (one, other)) in batch.iter().zip(expected).enumerate() {
        assert_same_element(&one, other, &format!("{operation} at {index}"));
    }
}

/// Asserts that an element is another one up to rounding.
pub fn assert_same_element<X>(one: &X, other: &X, operation: &str)
where
    X: Element<Number: Number + Into<f64>> + std::fmt::Debug,
{
    let positions = || 0..X::BLADES.len();
    let size = |x: &X| {
        positions()
            .map(|i| x.at(i).into().abs())
            .filter(|size| size.is_finite())
            .fold(8.0, f64::max)
    };
    let size = size(one).max(size(other));
    assert!(
        positions().all(|i| same(one.at(i), other.at(i), size)),
        "{operation} on {:?}: {one:?} instead of {other:?}",
        Target::current()
    );
}
