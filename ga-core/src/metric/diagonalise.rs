//! Signature and determinant of a symmetric matrix by exact congruence.

use alloc::vec::Vec;

use num_traits::{CheckedAdd, CheckedDiv, CheckedMul, CheckedSub};

use crate::Rational;

/// The diagonal of a matrix congruent to `gram` by a transformation of determinant ±1;
/// `None` on overflow. Zeros stand last.
pub(super) fn pivots(mut gram: Vec<Vec<Rational>>) -> Option<Vec<Rational>> {
    let dimension = gram.len();
    for step in 0..dimension {
        if !bring_pivot(&mut gram, step)? {
            break;
        }
        let pivot_row = gram[step].clone();
        for row in gram.iter_mut().skip(step + 1) {
            let factor = row[step].checked_div(&pivot_row[step])?;
            if factor == Rational::ZERO {
                continue;
            }
            for (entry, above) in row.iter_mut().zip(&pivot_row).skip(step) {
                *entry = entry.checked_sub(&factor.checked_mul(above)?)?;
            }
        }
    }
    Some((0..dimension).map(|index| gram[index][index]).collect())
}

/// Makes the diagonal entry at `step` non-zero by exchanging basis vectors or, when all
/// remaining squares are zero, by adding one vector to another that it meets: (u+v)² = 2 u·v.
/// `Some(false)` when all remaining entries are zero.
fn bring_pivot(gram: &mut [Vec<Rational>], step: usize) -> Option<bool> {
    let dimension = gram.len();
    if let Some(index) = (step..dimension).find(|&index| gram[index][index] != Rational::ZERO) {
        exchange(gram, step, index);
        return Some(true);
    }
    let mut pairs = (step..dimension).flat_map(|i| (i + 1..dimension).map(move |j| (i, j)));
    let Some((i, j)) = pairs.find(|&(i, j)| gram[i][j] != Rational::ZERO) else {
        return Some(false);
    };
    let (before, from_j) = gram.split_at_mut(j);
    for (entry, other) in before[i].iter_mut().zip(&from_j[0]) {
        *entry = entry.checked_add(other)?;
    }
    for row in gram.iter_mut() {
        row[i] = row[i].checked_add(&row[j])?;
    }
    exchange(gram, step, i);
    Some(true)
}

fn exchange(gram: &mut [Vec<Rational>], i: usize, j: usize) {
    gram.swap(i, j);
    for row in gram {
        row.swap(i, j);
    }
}

/// The numbers of positive, negative and zero pivots.
pub(super) fn signature(pivots: &[Rational]) -> (usize, usize, usize) {
    let count = |wanted: fn(&Rational) -> bool| pivots.iter().filter(|pivot| wanted(pivot)).count();
    (
        count(|pivot| *pivot > Rational::ZERO),
        count(|pivot| *pivot < Rational::ZERO),
        count(|pivot| *pivot == Rational::ZERO),
    )
}

/// The product of the pivots; `None` on overflow.
pub(super) fn determinant(pivots: &[Rational]) -> Option<Rational> {
    // A zero first: it spares the other factors from overflowing.
    if pivots.contains(&Rational::ZERO) {
        return Some(Rational::ZERO);
    }
    pivots
        .iter()
        .try_fold(Rational::ONE, |product, pivot| product.checked_mul(pivot))
}
