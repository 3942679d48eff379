//! The geometric product of two outer products, as a sum over contractions.
//!
//! With e_S = s₁ ∧ … ∧ s_m and e_T = t₁ ∧ … ∧ t_n, every vector of S is either contracted with
//! one of T or kept (Wick's expansion; in a diagonal metric only equal vectors contract):
//!
//! ```text
//! e_S e_T = Σ over partial matchings   ± Π (s·t) over matched pairs   e_{S rest} ∧ e_{T rest}
//! ```

use alloc::collections::BTreeMap;
use alloc::vec;
use alloc::vec::Vec;

use num_traits::{CheckedAdd, CheckedMul};

use crate::{Blade, Metric, Rational, reorder_sign};

/// The terms of e_a e_b whose grades `keep` accepts, in blade order; `None` on overflow.
pub(super) fn terms(
    metric: &Metric,
    a: Blade,
    b: Blade,
    keep: fn(u32, u32, u32) -> bool,
) -> Option<Vec<(Blade, Rational)>> {
    let (left, right) = (a.grade(), b.grade());
    // c contractions leave grade left + right − 2c.
    let mut wanted =
        (0..=left.min(right)).filter(|count| keep(left, right, left + right - 2 * count));
    let Some(fewest) = wanted.next() else {
        return Some(Vec::new());
    };
    let most = wanted.next_back().unwrap_or(fewest);
    let mut terms = if metric.is_diagonal() {
        diagonal(metric, a, b)?
    } else {
        matchings(metric, a, b, fewest, most)?
    };
    terms.retain(|&(blade, coefficient)| {
        coefficient != Rational::ZERO && keep(left, right, blade.grade())
    });
    Some(terms)
}

/// Orthogonal basis vectors: the union without the common ones, which are contracted
/// (algorithms A.2 and A.3).
fn diagonal(metric: &Metric, a: Blade, b: Blade) -> Option<Vec<(Blade, Rational)>> {
    let sign = reorder_sign(a.mask(), b.mask());
    let common = Blade::new(a.mask() & b.mask());
    let mut coefficient = Rational::from_integer(i128::from(sign));
    for index in common.indices() {
        coefficient = coefficient.checked_mul(&metric.gram(index, index))?;
    }
    Some(vec![(Blade::new(a.mask() ^ b.mask()), coefficient)])
}

/// Any basis: the vectors of `a` are taken from the last to the first; partial results that
/// agree in what is kept of `a` and what is left of `b` are merged, so that determinants of the
/// Gram matrix arise without being expanded.
fn matchings(
    metric: &Metric,
    a: Blade,
    b: Blade,
    fewest: u32,
    most: u32,
) -> Option<Vec<(Blade, Rational)>> {
    let mut states = BTreeMap::from([((0_u32, b.mask()), Rational::ONE)]);
    let mut to_come = a.grade();
    for s in a.indices().rev() {
        to_come -= 1;
        let mut next = BTreeMap::new();
        for ((kept, rest), coefficient) in states {
            let contracted = b.grade() - rest.count_ones();
            if contracted + to_come >= fewest {
                add(&mut next, (kept | 1 << s, rest), coefficient)?;
            }
            if contracted == most {
                continue;
            }
            for t in Blade::new(rest).indices() {
                let inner = metric.gram(s, t);
                if inner == Rational::ZERO {
                    continue;
                }
                // t moves to s: past the vectors left before it and past those kept of a.
                let passed = kept.count_ones() + (rest & ((1 << t) - 1)).count_ones();
                let sign = if passed % 2 == 0 { 1 } else { -1 };
                let factor = inner.checked_mul(&Rational::from_integer(sign))?;
                let product = coefficient.checked_mul(&factor)?;
                add(&mut next, (kept, rest & !(1 << t)), product)?;
            }
        }
        states = next;
    }
    let mut sums = BTreeMap::new();
    for ((kept, rest), coefficient) in states {
        if kept & rest == 0 {
            let sign = Rational::from_integer(i128::from(reorder_sign(kept, rest)));
            add(
                &mut sums,
                Blade::new(kept | rest),
                coefficient.checked_mul(&sign)?,
            )?;
        }
    }
    Some(sums.into_iter().collect())
}

/// Adds `value` to the entry at `key`; `None` on overflow.
fn add<Key: Ord>(sums: &mut BTreeMap<Key, Rational>, key: Key, value: Rational) -> Option<()> {
    let entry = sums.entry(key).or_insert(Rational::ZERO);
    *entry = entry.checked_add(&value)?;
    Some(())
}
