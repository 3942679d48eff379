//! Products of blades of any metric, spelled out pair by pair.

use super::operand::{BLADES, Operand};
use crate::Scalar;

/// All terms of all products of two blades; see [`Table::new`](super::Table::new).
#[derive(Clone, Copy, Debug)]
pub(super) struct Rows {
    pub(super) entries: &'static [u8],
    pub(super) coefficients: &'static [(i64, i64)],
}

impl Rows {
    /// Adds the parts of the product whose grades are kept.
    pub(super) fn add<T: Scalar>(
        &self,
        dimension: u32,
        left: &Operand<T>,
        right: &Operand<T>,
        keep: fn(u32, u32, u32) -> bool,
        number: impl Fn(i64, i64) -> T,
        result: &mut [T; BLADES],
    ) {
        let (mut x, mut y) = ([T::ZERO; BLADES], [T::ZERO; BLADES]);
        for (operand, values) in [(left, &mut x), (right, &mut y)] {
            for (mask, value) in operand.terms() {
                values[*mask as usize % BLADES] = *value;
            }
        }
        let mut entries = self.entries;
        for (i, x) in (0..1_u32 << dimension).zip(x) {
            let Some((&[low, high], rest)) = entries.split_first_chunk() else {
                return;
            };
            let length = usize::from(u16::from_le_bytes([low, high]));
            let (mut row, rest) = rest.split_at(length.min(rest.len()));
            entries = rest;
            if x == T::ZERO {
                continue;
            }
            for (j, y) in (0..1_u32 << dimension).zip(y) {
                let Some((&terms, rest)) = row.split_first() else {
                    break;
                };
                let (terms, rest) = rest.split_at(rest.len().min(2 * usize::from(terms)));
                row = rest;
                if y == T::ZERO {
                    continue;
                }
                let factor = x * y;
                for term in terms.chunks_exact(2) {
                    let mask = u32::from(term[0]);
                    if keep(i.count_ones(), j.count_ones(), mask.count_ones()) {
                        let (numerator, denominator) = self.coefficients[usize::from(term[1])];
                        let value = match (numerator, denominator) {
                            (1, 1) => factor,
                            (-1, 1) => -factor,
                            _ => factor * number(numerator, denominator),
                        };
                        result[mask as usize] += value;
                    }
                }
            }
        }
    }
}
