//! Making metrics: signatures, names, and every way in which a description can be wrong.

use ga_core::{Blade, Metric, MetricError, Rational};
use proptest::prelude::*;

use crate::catalogue::{self, fraction};

fn names(metric: &Metric) -> Vec<String> {
    let blades = metric.blades();
    blades
        .into_iter()
        .map(|blade| metric.blade_name(blade))
        .collect()
}

fn integers(rows: &[&[i128]]) -> Vec<Vec<Rational>> {
    let row = |row: &&[i128]| row.iter().copied().map(Rational::from_integer).collect();
    rows.iter().map(row).collect()
}

#[test]
fn signatures_and_determinants() {
    let expect = |metric: Metric, signature, determinant| {
        assert_eq!(metric.signature(), signature);
        assert_eq!(metric.determinant(), determinant);
        assert_eq!(metric.is_degenerate(), signature.2 > 0);
    };
    expect(catalogue::conformal(), (4, 1, 0), fraction(-1, 1));
    expect(catalogue::oblique(), (2, 1, 0), fraction(-19, 2));
    expect(catalogue::oblique_degenerate(), (1, 1, 1), fraction(0, 1));
    expect(catalogue::orthonormal(3, 0, 1), (3, 0, 1), fraction(0, 1));
    expect(catalogue::orthonormal(0, 0, 0), (0, 0, 0), fraction(1, 1));
    expect(catalogue::orthonormal(9, 5, 2), (9, 5, 2), fraction(0, 1));
}

proptest! {
    /// Sylvester's law: another basis, made by adding multiples of vectors to others, has the
    /// same signature, and the same determinant.
    #[test]
    fn signature_does_not_depend_on_the_basis(
        squares in proptest::collection::vec(-2..=2_i128, 5),
        steps in proptest::collection::vec((0..5_usize, 0..5_usize, -2..=2_i128), 0..8),
    ) {
        let mut gram = vec![vec![0; 5]; 5];
        for (index, &square) in squares.iter().enumerate() {
            gram[index][index] = square;
        }
        for (to, from, factor) in steps.into_iter().filter(|(to, from, _)| to != from) {
            let added = gram[from].clone();
            for (entry, added) in gram[to].iter_mut().zip(added) {
                *entry += factor * added;
            }
            for row in &mut gram {
                row[to] += factor * row[from];
            }
        }
        let rows: Vec<&[i128]> = gram.iter().map(Vec::as_slice).collect();
        let metric = Metric::new(["a", "b", "c", "d", "e"], integers(&rows)).unwrap();
        let count = |sign| squares.iter().filter(|square| square.signum() == sign).count();
        prop_assert_eq!(metric.signature(), (count(1), count(-1), count(0)));
        let determinant: i128 = squares.iter().product();
        prop_assert_eq!(metric.determinant(), Rational::from_integer(determinant));
    }

    /// Whatever the matrix, there is a metric or a typed error.
    #[test]
    fn no_matrix_panics(
        entries in proptest::collection::vec((any::<i128>(), any::<i128>()), 9),
        shift in 0..128_u32,
    ) {
        let entry = |(numerator, denominator): (i128, i128)| {
            Rational::new_raw(numerator >> shift, denominator >> shift)
        };
        let mut gram = vec![vec![Rational::ZERO; 3]; 3];
        for (row, line) in gram.iter_mut().enumerate() {
            for (column, found) in line.iter_mut().enumerate() {
                *found = entry(entries[row.min(column) * 3 + row.max(column)]);
            }
        }
        if let Ok(metric) = Metric::new(["a", "b", "c"], gram) {
            for a in metric.blades() {
                for b in metric.blades() {
                    let _ = ga_core::product::geometric(&metric, a, b);
                }
                let _ = ga_core::dual::dual(&metric, a);
            }
        }
    }
}

#[test]
fn names_of_blades() {
    let plane = catalogue::orthonormal(2, 0, 0);
    assert_eq!(names(&plane), ["1", "e1", "e2", "e12"]);
    let conformal = catalogue::conformal();
    assert_eq!(conformal.blade_name(Blade::new(0b10011)), "e12ni");
    assert_eq!(conformal.blade_name(Blade::new(0b11000)), "noni");
    let many = catalogue::orthonormal(12, 0, 0);
    assert_eq!(many.blade_name(Blade::new(0b11)), "e1^e2");
    assert_eq!(many.blade_name(Blade::new(1 << 9 | 1)), "e1^e10");
    assert_eq!(many.blade_name(Blade::new(1 << 11)), "e12");
}

/// A name and a sequence of names that read the same are told apart by wedges.
#[test]
fn names_of_blades_are_distinct() {
    let zero = |count: usize| vec![vec![Rational::ZERO; count]; count];
    let clash = Metric::new(["a", "b", "ab"], zero(3)).unwrap();
    assert_eq!(clash.blade_name(Blade::new(0b011)), "a^b");
    let mixed = Metric::new(["e1", "f1", "f2"], zero(3)).unwrap();
    assert_eq!(mixed.blade_name(Blade::new(0b111)), "e1f12");
    for metric in [
        clash,
        mixed,
        catalogue::conformal(),
        catalogue::orthonormal(10, 0, 0),
    ] {
        let mut names = names(&metric);
        names.sort();
        names.dedup();
        assert_eq!(names.len(), 1 << metric.dimension());
    }
}

#[test]
fn inner_products_beyond_the_dimension_are_zero() {
    let metric = catalogue::oblique();
    assert_eq!(metric.gram(1, 2), fraction(1, 2));
    assert_eq!(metric.gram(1, 3), Rational::ZERO);
    assert_eq!(metric.gram(usize::MAX, 0), Rational::ZERO);
    assert!(!metric.is_diagonal());
    assert!(catalogue::orthonormal(3, 0, 1).is_diagonal());
}

#[test]
fn wrong_descriptions() {
    let expect = |names: &[&str], gram, error: MetricError, message: &str| {
        let found = Metric::new(names.iter().copied(), gram);
        assert_eq!(found, Err(error.clone()));
        assert_eq!(error.to_string(), message);
    };
    let two = || integers(&[&[1, 0], &[0, 1]]);
    expect(
        &["a", ""],
        two(),
        MetricError::EmptyName { index: 1 },
        "basis vector 1 has no name",
    );
    expect(
        &["a", "a"],
        two(),
        MetricError::DuplicateName {
            name: "a".into(),
            first: 0,
            second: 1,
        },
        "basis vectors 0 and 1 are both named `a`",
    );
    expect(
        &["a", "b", "c"],
        two(),
        MetricError::RowCount {
            rows: 2,
            dimension: 3,
        },
        "the matrix has 2 rows for 3 basis vectors",
    );
    expect(
        &["a", "b"],
        integers(&[&[1, 0], &[0]]),
        MetricError::ColumnCount {
            row: 1,
            columns: 1,
            dimension: 2,
        },
        "row 1 of the matrix has 1 entries for 2 basis vectors",
    );
    expect(
        &["a", "b"],
        integers(&[&[1, 2], &[3, 1]]),
        MetricError::NotSymmetric { row: 1, column: 0 },
        "the matrix is not symmetric: the entries at (1, 0) and (0, 1) differ",
    );
    expect(
        &["a"],
        vec![vec![Rational::new_raw(1, 0)]],
        MetricError::ZeroDenominator { row: 0, column: 0 },
        "the entry at (0, 0) has denominator zero",
    );
    expect(
        &["a"],
        integers(&[&[i128::MIN]]),
        MetricError::Overflow,
        "the entries are too large or too varied for exact 128-bit fractions",
    );
    let many = MetricError::TooManyDimensions { dimension: 17 };
    assert_eq!(Metric::from_signature(8, 8, 1), Err(many.clone()));
    assert_eq!(
        many.to_string(),
        "17 basis vectors are more than the 16 supported"
    );
    assert!(Metric::from_signature(usize::MAX, usize::MAX, usize::MAX).is_err());
}

#[test]
fn fractions_are_brought_to_lowest_terms() {
    let metric = Metric::new(["a"], vec![vec![Rational::new_raw(-2, -4)]]).unwrap();
    assert_eq!(metric.gram(0, 0), fraction(1, 2));
    assert_eq!(metric.signature(), (1, 0, 0));
}
