//! Products of basis blades as two independent programs give them (tests/data).

use ga_core::product::product;
use ga_core::{Blade, Metric, Product, Rational};

fn metric(rows: &str) -> Metric {
    let gram: Vec<Vec<Rational>> = rows
        .split(';')
        .map(|row| row.split(',').map(|entry| entry.parse().unwrap()).collect())
        .collect();
    Metric::new((0..gram.len()).map(|index| format!("v{index}")), gram).unwrap()
}

fn blade(mask: &str) -> Blade {
    Blade::new(mask.parse().unwrap())
}

/// Compares every line and returns their number.
fn compare(table: &str) -> usize {
    let mut current = None;
    let mut compared = 0;
    for line in table.lines().filter(|line| !line.starts_with('#')) {
        let columns: Vec<&str> = line.split('\t').collect();
        if let ["metric", rows] = columns[..] {
            current = Some(metric(rows));
            continue;
        }
        let [method, left, right, terms] = columns[..] else {
            panic!("a line with other columns: {line}");
        };
        let which = Product::ALL
            .into_iter()
            .find(|which| which.method() == method);
        let mut expected: Vec<(Blade, Rational)> = terms
            .split_whitespace()
            .map(|term| term.split_once(':').unwrap())
            .map(|(mask, coefficient)| (blade(mask), coefficient.parse().unwrap()))
            .collect();
        expected.sort();
        let metric = current.as_ref().unwrap();
        let found = product(metric, which.unwrap(), blade(left), blade(right));
        assert_eq!(found, Some(expected), "{:?}: {line}", metric.signature());
        compared += 1;
    }
    compared
}

#[test]
fn kingdon_agrees() {
    assert_eq!(compare(include_str!("../data/kingdon.tsv")), 3011);
}

#[test]
fn galgebra_agrees() {
    assert_eq!(compare(include_str!("../data/galgebra.tsv")), 1600);
}
