//! The random data that every library gets, in coordinates that belong to none.

use ga_benches::race::ELEMENTS;
use rand::rngs::StdRng;
use rand::{RngExt, SeedableRng};

/// A rigid motion x ↦ q x q⁻¹ + t.
#[derive(Clone, Copy)]
pub struct Motion {
    /// The unit quaternion as w, x, y, z.
    pub rotation: [f64; 4],
    /// The translation.
    pub translation: [f64; 3],
}

/// A source of elements, the same at every run.
pub struct Source(StdRng);

impl Source {
    /// The source of this number.
    pub fn new(seed: u64) -> Self {
        Source(StdRng::seed_from_u64(seed))
    }

    fn coordinates<const N: usize>(&mut self) -> [f64; N] {
        std::array::from_fn(|_| self.0.random_range(-1.0..1.0))
    }

    fn unit<const N: usize>(&mut self) -> [f64; N] {
        loop {
            let x = self.coordinates();
            let norm = x.iter().map(|x| x * x).sum::<f64>().sqrt();
            if norm > 0.1 {
                return x.map(|x| x / norm);
            }
        }
    }

    /// Points of a cube of edge 2.
    pub fn vectors(&mut self) -> Vec<[f64; 3]> {
        (0..ELEMENTS).map(|_| self.coordinates()).collect()
    }

    /// Rotations by at most a third of a turn, whose logarithms are unique with either sign.
    pub fn rotations(&mut self) -> Vec<[f64; 4]> {
        let mut rotation = || loop {
            let [w, x, y, z] = self.unit();
            if w > 0.5 {
                return [w, x, y, z];
            }
        };
        (0..ELEMENTS).map(|_| rotation()).collect()
    }

    /// Rigid motions.
    pub fn motions(&mut self) -> Vec<Motion> {
        let rotations = self.rotations();
        let pair = |rotation| Motion {
            rotation,
            translation: self.coordinates(),
        };
        rotations.into_iter().map(pair).collect()
    }

    /// Planes as unit normal and offset, n·x + d = 0.
    pub fn planes(&mut self) -> Vec<[f64; 4]> {
        let mut plane = || {
            let ([a, b, c], [d]) = (self.unit(), self.coordinates());
            [a, b, c, d]
        };
        (0..ELEMENTS).map(|_| plane()).collect()
    }
}
