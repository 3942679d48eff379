//! A metric is symmetric, rational, between named vectors, and of the declared signature.

use std::collections::HashMap;

use ga_core::{Metric, Rational};
use proc_macro2::Ident;

use super::signature::{self, Counts};
use crate::ast::{Algebra, MetricEntry};
use crate::blades::{self, Reading, spelled};
use crate::errors::{Errors, Mistake, closest};
use crate::parse::is_plain_identifier;

/// The basis names as many distinct vectors as the signature counts; what is returned are as
/// many distinct names as there are vectors to work with, whatever was written.
pub fn basis_names(
    algebra: &Algebra,
    counts: Option<Counts>,
    vectors: usize,
    errors: &mut Errors,
) -> Vec<String> {
    let Some(basis) = &algebra.basis else {
        return (1..=vectors).map(|i| format!("e{i}")).collect();
    };
    let names: Vec<String> = basis.iter().map(Ident::to_string).collect();
    for (i, (name, token)) in names.iter().zip(basis).enumerate() {
        if names[..i].contains(name) {
            errors.push(token.span(), Mistake::DuplicateBasisName(name.clone()));
        } else if name == "s" || name == "T" || !is_plain_identifier(name) {
            errors.push(token.span(), Mistake::ReservedBasisName(name.clone()));
        } else if let Some(reading) = other_reading(name, &names) {
            let name = name.clone();
            errors.push(token.span(), Mistake::AmbiguousBasisName { name, reading });
        }
    }
    // Of a name that could not be read nobody knows whether it would have been one.
    let unread =
        errors.any(|mistake| matches!(mistake, Mistake::NotAName | Mistake::Unexpected(_)));
    let declared = counts.map(signature::total);
    if let Some(expected) = declared.filter(|count| *count != names.len() && !unread) {
        // The first name too many, else the section's last, else the signature.
        let spans = match basis.get(expected).or(basis.last()) {
            Some(token) => (token.span(), token.span()),
            None => algebra.signature.spans,
        };
        let mistake = Mistake::BasisCount {
            signature: algebra.signature.text.clone(),
            expected,
            found: names.len(),
        };
        errors.push_range(spans, mistake);
    }
    // Something that was not written stands for what cannot be used.
    let placeholder = |i: usize| {
        let mut name = format!("{}{i}", blades::PLACEHOLDER);
        while names.contains(&name) {
            name.push('_');
        }
        name
    };
    (0..vectors)
        .map(|i| match names.get(i) {
            Some(name) if !names[..i].contains(name) => name.clone(),
            _ => placeholder(i),
        })
        .collect()
}

/// How a basis name reads as a product of other basis vectors.
fn other_reading(name: &str, names: &[String]) -> Option<String> {
    // From ten vectors on `e12` is a vector, and blades are spelled with `^`.
    if names.len() >= 10 {
        return None;
    }
    let others: Vec<String> = names.iter().filter(|n| *n != name).cloned().collect();
    match blades::read(name, &others) {
        Reading::Unknown => None,
        Reading::Blade(indices) | Reading::Ambiguous(indices, _) => {
            Some(spelled(&indices, &others))
        }
    }
}

/// The metric is symmetric and rational; without one, the vectors are orthonormal.
pub fn metric(
    algebra: &Algebra,
    counts: Option<Counts>,
    names: &[String],
    errors: &mut Errors,
) -> Option<Metric> {
    let dimension = names.len();
    let mut gram = vec![vec![Rational::from_integer(0); dimension]; dimension];
    match &algebra.metric {
        None => {
            let (p, q, _) = counts.unwrap_or((dimension, 0, 0));
            for (i, row) in gram.iter_mut().enumerate().take(p.saturating_add(q)) {
                row[i] = Rational::from_integer(if i < p { 1 } else { -1 });
            }
        }
        Some(entries) => fill(algebra, entries, names, &mut gram, errors),
    }
    let metric = Metric::new(names.to_vec(), gram);
    if metric.is_err() {
        // Names are distinct and the matrix is square and symmetric: only size is left.
        errors.push_range(algebra.signature.spans, Mistake::Overflow);
    }
    metric.ok()
}

fn fill(
    algebra: &Algebra,
    entries: &[MetricEntry],
    names: &[String],
    gram: &mut [Vec<Rational>],
    errors: &mut Errors,
) {
    let mut given: HashMap<(usize, usize), (Rational, usize)> = HashMap::new();
    for entry in entries {
        let mut index = |token: &Ident| index(token, names, algebra.basis.is_some(), errors);
        let i = index(&entry.left);
        let right = entry.right.as_ref();
        let j = right.map_or(i, index);
        let (Some(i), Some(j)) = (i, j) else {
            continue;
        };
        let (numerator, denominator) = entry.value.value;
        let value = Rational::new(numerator, denominator);
        let second = right.unwrap_or(&entry.left);
        let text = match right {
            Some(right) => format!("{}.{right}", entry.left),
            None => format!("{}^2", entry.left),
        };
        match given.insert((i.min(j), i.max(j)), (value, i)) {
            Some((before, first)) if before != value => {
                let mistake = if first == i {
                    Mistake::ContradictoryMetricEntry(text)
                } else {
                    Mistake::NotSymmetric(text)
                };
                errors.push_range(entry.value.spans, mistake);
            }
            Some(_) => {
                let spans = (entry.left.span(), second.span());
                errors.push_range(spans, Mistake::DuplicateMetricEntry(text));
            }
            None => {}
        }
        gram[i][j] = value;
        gram[j][i] = value;
    }
}

/// The position of a basis vector.
fn index(token: &Ident, names: &[String], named: bool, errors: &mut Errors) -> Option<usize> {
    let name = token.to_string();
    let index = names.iter().position(|n| *n == name);
    if index.is_none() {
        let mistake = Mistake::UnknownBasisVector {
            basis: blades::listed(names),
            named,
            suggestion: closest(&name, names.iter().map(String::as_str)),
            name,
        };
        errors.push(token.span(), mistake);
    }
    index
}

/// The metric has the signature that is declared.
pub fn has_signature(
    algebra: &Algebra,
    counts: Option<Counts>,
    metric: &Metric,
    errors: &mut Errors,
) {
    let Some(declared) = counts else {
        return;
    };
    let actual = metric.signature();
    // A wrong number of basis vectors has been reported already and says more.
    // So does an entry that could not be used.
    let incomplete = errors.any(Mistake::is_about_metric);
    if declared != actual && !incomplete && signature::total(declared) == metric.dimension() {
        let mistake = Mistake::SignatureMismatch {
            declared: algebra.signature.text.clone(),
            actual: signature::text(actual.0, actual.1, actual.2),
            degenerate: algebra.metric.is_some() && actual.2 > declared.2,
        };
        errors.push_range(algebra.signature.spans, mistake);
    }
}
