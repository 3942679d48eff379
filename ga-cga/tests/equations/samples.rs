//! The samples that the equations are tested on, the same in every run, and what counts as
//! equal.

use ga_core::ops::Element;
use ga_core::{Field, Rational, Scalar};

/// How many samples an equation is tested on.
const COUNT: usize = 24;

/// A linear congruential generator.
pub struct Samples(u64);

/// Numbers that samples are made of.
pub trait Sample: Field {
    /// The next number, never zero.
    fn next(samples: &mut Samples) -> Self;
}

impl Sample for Rational {
    /// A fraction of small integers.
    fn next(samples: &mut Samples) -> Self {
        let numerator = samples.below(6) + 1;
        let sign = 1 - 2 * samples.below(2);
        Rational::new(sign * numerator, samples.below(4) + 1)
    }
}

impl Sample for f64 {
    /// A number in [−2, −¹⁄₁₆] or [¹⁄₁₆, 2].
    fn next(samples: &mut Samples) -> Self {
        let size = 0.0625 + 1.9375 * samples.below(1 << 31) as f64 / (1_u64 << 31) as f64;
        if samples.below(2) == 0 { size } else { -size }
    }
}

impl Samples {
    /// The next integer from 0 to `bound` − 1.
    fn below(&mut self, bound: i128) -> i128 {
        self.0 = self
            .0
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        i128::from(self.0 >> 33) % bound
    }

    /// The next number.
    pub fn number<T: Sample>(&mut self) -> T {
        T::next(self)
    }

    /// A whole number from 1 to `bound`.
    pub fn positive(&mut self, bound: i128) -> Rational {
        Rational::from_integer(self.below(bound) + 1)
    }

    /// A whole number from −`bound` to `bound`, never zero.
    pub fn whole(&mut self, bound: i128) -> Rational {
        let size = self.positive(bound);
        if self.below(2) == 0 { size } else { -size }
    }

    /// An element with random coefficients, none of them zero.
    pub fn element<E: Element>(&mut self) -> E
    where
        E::Number: Sample,
    {
        E::from_fn(|_| self.number())
    }
}

/// Runs a test on one sample after another.
pub fn each(mut test: impl FnMut(&mut Samples)) {
    let mut samples = Samples(2);
    for _ in 0..COUNT {
        test(&mut samples);
    }
}

/// The element with one coefficient 1, at a position of the type's list.
pub fn unit<E: Element>(position: usize) -> E {
    E::from_fn(|own| {
        if own == position {
            E::Number::ONE
        } else {
            E::Number::ZERO
        }
    })
}

/// The coefficients agree to a tolerance relative to the largest, and absolute below 1.
pub fn close<E: Element<Number = f64> + std::fmt::Debug>(found: E, expected: E, tolerance: f64) {
    let positions = 0..E::BLADES.len();
    let largest = positions
        .clone()
        .fold(1.0, |largest: f64, at| largest.max(expected.at(at).abs()));
    for at in positions {
        let miss = (found.at(at) - expected.at(at)).abs();
        assert!(
            miss <= tolerance * largest,
            "{found:?} is not {expected:?}, by {miss:e}"
        );
    }
}

/// Two numbers agree to a tolerance relative to the expected one, and absolute below 1.
pub fn near(found: f64, expected: f64, tolerance: f64) {
    let miss = (found - expected).abs();
    assert!(
        miss <= tolerance * expected.abs().max(1.0),
        "{found} is not {expected}, by {miss:e}"
    );
}
