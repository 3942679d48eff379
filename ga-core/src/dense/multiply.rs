//! The geometric product from the product of a vector and a multivector alone.
//!
//! e_i X = e_i ∧ X + e_i ⌋ X, and an outer product is resolved from its first vector on:
//! (e_i ∧ Y) X = e_i (Y X) − (e_i ⌋ Y) X.

use alloc::vec;
use alloc::vec::Vec;

use crate::Scalar;

/// The product of two lists of 2ⁿ coefficients, where `gram` has n² entries.
pub(super) fn multiply<T: Scalar>(gram: &[T], dimension: usize, left: &[T], right: &[T]) -> Vec<T> {
    multiply_from(gram, dimension, 0, left, right)
}

/// The same for a left factor without the basis vectors before number `first`.
fn multiply_from<T: Scalar>(
    gram: &[T],
    dimension: usize,
    first: usize,
    left: &[T],
    right: &[T],
) -> Vec<T> {
    if is_zero(left) {
        return vec![T::ZERO; right.len()];
    }
    if first == dimension {
        return right.iter().map(|&value| left[0] * value).collect();
    }
    // left = without + e_first ∧ with
    let bit = 1 << first;
    let mut without = vec![T::ZERO; left.len()];
    let mut with = vec![T::ZERO; left.len()];
    for (mask, &value) in left.iter().enumerate() {
        if mask & bit == 0 {
            without[mask] = value;
        } else {
            with[mask - bit] = value;
        }
    }
    if is_zero(&with) {
        return multiply_from(gram, dimension, first + 1, &without, right);
    }
    for (value, contracted) in without
        .iter_mut()
        .zip(contract(gram, dimension, first, &with))
    {
        *value -= contracted;
    }
    let mut result = multiply_from(gram, dimension, first + 1, &without, right);
    let product = multiply_from(gram, dimension, first + 1, &with, right);
    let outer = extend(dimension, first, &product);
    let inner = contract(gram, dimension, first, &product);
    for ((value, outer), inner) in result.iter_mut().zip(outer).zip(inner) {
        *value += outer + inner;
    }
    result
}

/// e_i ∧ X: the new vector passes those with lower numbers.
fn extend<T: Scalar>(dimension: usize, index: usize, x: &[T]) -> Vec<T> {
    let mut result = vec![T::ZERO; x.len()];
    for (mask, &value) in x.iter().enumerate() {
        if mask >> index & 1 == 0 && value != T::ZERO {
            let passed = members(dimension, mask)
                .filter(|&member| member < index)
                .count();
            result[mask | 1 << index] = alternate(passed, value);
        }
    }
    result
}

/// e_i ⌋ X: each vector in turn is brought to the front and contracted.
fn contract<T: Scalar>(gram: &[T], dimension: usize, index: usize, x: &[T]) -> Vec<T> {
    let mut result = vec![T::ZERO; x.len()];
    for (mask, &value) in x.iter().enumerate() {
        if value == T::ZERO {
            continue;
        }
        for (passed, member) in members(dimension, mask).enumerate() {
            let inner = gram[index * dimension + member];
            result[mask & !(1 << member)] += alternate(passed, inner * value);
        }
    }
    result
}

fn is_zero<T: Scalar>(x: &[T]) -> bool {
    x.iter().all(|&value| value == T::ZERO)
}

fn members(dimension: usize, mask: usize) -> impl Iterator<Item = usize> {
    (0..dimension).filter(move |index| mask >> index & 1 == 1)
}

fn alternate<T: Scalar>(exponent: usize, value: T) -> T {
    if exponent.is_multiple_of(2) {
        value
    } else {
        -value
    }
}
