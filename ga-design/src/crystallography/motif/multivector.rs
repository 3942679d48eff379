//! How every multivector is a motif: moved by versors, compared by coefficients, each with the tolerance
//! that a small displacement asks of it.
//!
//! A translation by d changes a coefficient by at most d times the coefficients of the blades that it comes
//! from, which have one n_∞ less or one n_o more. So blades are sorted by that count: n_o … −1, Euclidean
//! and E … 0, n_∞ … +1.

use ga_core::Element;

use super::{Coincidence, Fingerprint, Motif, MotifError};
use crate::crystallography::{Isometry, Movable};

/// The basis vectors n_o and n_∞ in the order of the conformal algebra: e1, e2, e3, no, ni.
const NO: u32 = 3;
const NI: u32 = 4;

impl<X> Motif for X
where
    X: Element<Number = f64> + Movable,
{
    fn moved(&self, by: &Isometry) -> Result<Self, MotifError> {
        Ok(self.moved_by(by))
    }

    fn coincides(&self, other: &Self, when: &Coincidence) -> bool {
        let tolerances = Tolerances::of(self, when);
        let within = |sign: f64| {
            (0..X::BLADES.len()).all(|i| {
                let off = (self.at(i) - sign * other.at(i)).abs();
                off <= tolerances.at(degree(mask::<X>(i)))
            })
        };
        // With a fixed coefficient, as of points, the negative is no element of the type.
        within(1.0) || (!when.is_oriented && X::FIXED.is_empty() && within(-1.0))
    }

    fn fingerprint(&self, when: &Coincidence) -> Fingerprint {
        let tolerances = Tolerances::of(self, when);
        let lowest = tolerances.lowest();
        let mut print = Fingerprint {
            values: [0.0; 3],
            tolerance: 0.0,
        };
        for i in 0..X::BLADES.len() {
            // What is further up follows, for copies of one motif, from position and attitude: the square of
            // a point's position, which would drown the position itself.
            let degree = degree(mask::<X>(i));
            if degree > lowest + 1 {
                continue;
            }
            for (k, value) in print.values.iter_mut().enumerate() {
                *value += self.at(i) * weight(mask::<X>(i), k);
            }
            print.tolerance += tolerances.at(degree);
        }
        print
    }
}

/// The mask of the blade of a coefficient.
fn mask<X: Element>(i: usize) -> u64 {
    X::BLADES
        .get(i)
        .map_or(0, |(blade, _)| u64::from(blade.mask()))
}

/// Factors n_∞ less factors n_o.
fn degree(mask: u64) -> i32 {
    let has = |bit: u32| i32::from(mask >> bit & 1 == 1);
    has(NI) - has(NO)
}

/// A number from −1 to 1 for each blade, in three series without relation to each other.
fn weight(mask: u64, series: usize) -> f64 {
    const STEPS: [f64; 3] = [1.0, 2.236_067_977_499_79, 3.605_551_275_463_99];
    let step = STEPS.get(series).copied().unwrap_or_default();
    (step * (mask as f64 + 0.7)).sin()
}

/// By how much coefficients of each degree may differ.
struct Tolerances {
    sizes: [f64; 3],
    distance: f64,
    angle: f64,
}

impl Tolerances {
    fn of<X: Element<Number = f64>>(element: &X, when: &Coincidence) -> Self {
        let mut sizes = [0.0_f64; 3];
        let mut count = |mask: u64, size: f64| {
            let slot = match degree(mask) {
                -1 => &mut sizes[0],
                0 => &mut sizes[1],
                _ => &mut sizes[2],
            };
            // A NaN must not get lost.
            *slot = if size > *slot || size.is_nan() {
                size
            } else {
                *slot
            };
        };
        for i in 0..X::BLADES.len() {
            count(mask::<X>(i), element.at(i).abs());
        }
        for (blade, _, numerator, denominator) in X::FIXED {
            let value = *numerator as f64 / *denominator as f64;
            count(u64::from(blade.mask()), value.abs());
        }
        Self {
            sizes,
            distance: when.distance,
            angle: when.angle,
        }
    }

    fn at(&self, degree: i32) -> f64 {
        let [low, middle, high] = self.sizes;
        let d = self.distance;
        match degree {
            -1 => self.angle * low,
            0 => self.angle * middle + d * low,
            _ => self.angle * high + d * middle + 0.5 * d * d * low,
        }
    }

    /// The lowest degree of which there are coefficients beyond rounding.
    fn lowest(&self) -> i32 {
        let [low, middle, high] = self.sizes;
        let none = 1e-12 * low.max(middle).max(high);
        if low > none {
            -1
        } else if middle > none {
            0
        } else {
            1
        }
    }
}
