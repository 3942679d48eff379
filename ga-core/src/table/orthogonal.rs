//! Products of blades of orthogonal vectors need no table: the vectors that are in one of the
//! blades alone remain, with a sign that is bilinear in the bitmasks.

use super::operand::{BLADES, Operand};
use crate::Scalar;

/// The grades of the blades by bitmask: counting bits is slow on the oldest machines.
const GRADES: [usize; BLADES] = {
    let mut grades = [0; BLADES];
    let mut mask = 0;
    while mask < BLADES {
        grades[mask] = (mask as u32).count_ones() as usize;
        mask += 1;
    }
    grades
};

/// Adds the parts of the product whose grades are kept.
pub(super) fn add<T: Scalar>(
    left: &Operand<T>,
    right: &Operand<T>,
    negative: u32,
    null: u32,
    keep: fn(u32, u32, u32) -> bool,
    result: &mut [T; BLADES],
) {
    let mut kept = [0_u16; 9];
    let mut known = None;
    for &(i, x) in left.terms() {
        if x == T::ZERO {
            continue;
        }
        let grade = i.count_ones();
        if known != Some(grade) {
            kept = kept_grades(grade, keep);
            known = Some(grade);
        }
        let (signs, signed) = (signs(i, negative), [x, -x]);
        for &(j, y) in right.terms() {
            let part = (i ^ j) as usize % BLADES;
            let wanted = kept[GRADES[j as usize % BLADES]] >> GRADES[part] & 1 == 1;
            if wanted && i & j & null == 0 {
                let minus = ((signs & j) as u8).count_ones() as usize & 1;
                result[part] = result[part].plus_product(signed[minus], y);
            }
        }
    }
}

/// For each grade of the right blade the grades of the result that are kept, as bits.
fn kept_grades(left: u32, keep: fn(u32, u32, u32) -> bool) -> [u16; 9] {
    let mut kept = [0; 9];
    for (right, bits) in (0..).zip(&mut kept) {
        for part in 0..9 {
            *bits |= u16::from(keep(left, right, part)) << part;
        }
    }
    kept
}

/// The bitmask whose common bits with a right blade are as many, up to even numbers, as vectors
/// change places and squares are negative.
fn signs(left: u32, negative: u32) -> u32 {
    let mut signs = left & negative;
    let mut higher = left >> 1;
    while higher != 0 {
        signs ^= higher;
        higher >>= 1;
    }
    signs
}
