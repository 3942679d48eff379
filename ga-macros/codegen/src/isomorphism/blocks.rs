//! Metrics that the method covers: every vector is orthogonal to all others, or to all but one
//! with which it forms a pair of null vectors.

use ga_core::{Metric, Rational};

use super::operands::Frame;

/// A metric as orthogonal blocks; vectors are bits.
#[derive(Clone, Debug, Default)]
pub struct Blocks {
    /// Vectors of square ±1.
    pub units: Vec<Unit>,
    /// Pairs of null vectors.
    pub pairs: Vec<Pair>,
    /// Vectors that are orthogonal to all, themselves included.
    pub null: Vec<u32>,
}

/// A vector of square 1 or −1.
#[derive(Clone, Copy, Debug)]
pub struct Unit {
    /// Its bit.
    pub bit: u32,
    /// Whether its square is −1.
    pub negative: bool,
}

/// Two null vectors with inner product 1 or −1.
#[derive(Clone, Copy, Debug)]
pub struct Pair {
    /// The bit of the first one in the order of the basis.
    pub first: u32,
    /// The bit of the second one.
    pub second: u32,
    /// Whether their inner product is −1.
    pub negative: bool,
}

impl Blocks {
    /// The blocks of a metric; `None` where it has others.
    pub fn of(metric: &Metric) -> Option<Blocks> {
        let mut blocks = Blocks::default();
        for i in 0..metric.dimension() {
            let mut met = (0..metric.dimension()).filter(|j| metric.gram(i, *j) != Rational::ZERO);
            let (partner, others) = (met.next(), met.next());
            if others.is_some() {
                return None;
            }
            let Some(j) = partner else {
                blocks.null.push(1 << i);
                continue;
            };
            let value = metric.gram(i, j);
            if !value.is_integer() || value.numer().unsigned_abs() != 1 {
                return None;
            }
            let negative = value < Rational::ZERO;
            if i == j {
                let bit = 1 << i;
                blocks.units.push(Unit { bit, negative });
            } else if i < j {
                let (first, second) = (1 << i, 1 << j);
                blocks.pairs.push(Pair {
                    first,
                    second,
                    negative,
                });
            }
        }
        Some(blocks)
    }

    /// The blocks of the even part, whose vectors are the products with the last vector of
    /// square ±1, and that vector; `None` where there is none.
    pub fn even(mut self) -> Option<(Blocks, Frame)> {
        let f = self.units.pop()?;
        // (e f)(e′ f) = −f² e e′
        for unit in &mut self.units {
            unit.negative ^= !f.negative;
        }
        for pair in &mut self.pairs {
            pair.negative ^= !f.negative;
        }
        Some((self, Frame::Even(f)))
    }
}
