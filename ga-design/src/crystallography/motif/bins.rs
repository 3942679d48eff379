//! How copies that may coincide are found in constant time: bins of their fingerprints.

use super::Fingerprint;
use std::collections::HashMap;

/// Indices of copies by their fingerprint.
pub(super) struct Bins {
    width: f64,
    reach: f64,
    bins: HashMap<[i64; 3], Vec<usize>>,
}

impl Bins {
    /// Empty bins fit for these fingerprints; `None` if one is not finite.
    pub(super) fn for_prints(prints: &[Fingerprint]) -> Option<Self> {
        let mut reach: f64 = 0.0;
        let mut size: f64 = 0.0;
        for print in prints {
            let all = print.values.into_iter().chain([print.tolerance]);
            for value in all.clone() {
                if !value.is_finite() {
                    return None;
                }
            }
            reach = reach.max(print.tolerance);
            size = print
                .values
                .into_iter()
                .fold(size, |size, value| size.max(value.abs()));
        }
        // Wider than rounding, and so wide that most prints look into one bin only; never so narrow that
        // their numbers would not be exact.
        let reach = reach.max(1e-12 * size);
        let width = (8.0 * reach).max(f64::MIN_POSITIVE);
        Some(Self {
            width,
            reach,
            bins: HashMap::new(),
        })
    }

    pub(super) fn insert(&mut self, values: [f64; 3], index: usize) {
        let bin = values.map(|value| self.bin(value));
        self.bins.entry(bin).or_default().push(index);
    }

    /// The indices in all bins that fingerprints within reach of this one can be in.
    pub(super) fn near(&self, values: [f64; 3]) -> Vec<usize> {
        let [xs, ys, zs] = values.map(|v| self.bin(v - self.reach)..=self.bin(v + self.reach));
        let mut found = Vec::new();
        for x in xs {
            for y in ys.clone() {
                for z in zs.clone() {
                    found.extend(self.bins.get(&[x, y, z]).into_iter().flatten());
                }
            }
        }
        found
    }

    fn bin(&self, value: f64) -> i64 {
        // A float becomes an integer by saturating.
        (value / self.width).floor() as i64
    }
}
