//! Where tries begin: points that fill the ranges of all joints evenly, always the same ones.

use crate::linkages::{Chain, Limits};

/// An additive recurrence whose steps are powers of the number φ with φᵈ⁺¹ = φ + 1 for d joints:
/// the golden ratio for one (Roberts 2018).
pub struct Seeds {
    ranges: Vec<Limits>,
    steps: Vec<f64>,
    parts: Vec<f64>,
}

impl Seeds {
    pub fn new(chain: &Chain) -> Self {
        let joints = chain.values().iter();
        let ranges: Vec<Limits> = joints.map(|joint| joint.limits.bounded()).collect();
        let degree = ranges.len() as i32 + 1;
        // φ is found by iteration, of which each step leaves less than half of the error.
        let root = (0..60).fold(2.0_f64, |root, _| {
            (root + 1.0).powf(1.0 / f64::from(degree))
        });
        Seeds {
            steps: (1..degree).map(|power| root.powi(-power)).collect(),
            parts: vec![0.5; ranges.len()],
            ranges,
        }
    }

    pub fn next_values(&mut self) -> Vec<f64> {
        for (part, step) in self.parts.iter_mut().zip(&self.steps) {
            *part = (*part + step).fract();
        }
        let pairs = self.ranges.iter().zip(&self.parts);
        pairs
            .map(|(range, part)| range.lower + part * (range.upper - range.lower))
            .collect()
    }
}
