//! The metrics on which laws are tested.

use ga_core::{Metric, Rational};

/// An exact fraction.
pub fn fraction(numerator: i128, denominator: i128) -> Rational {
    Rational::new(numerator, denominator)
}

/// The orthonormal metric of a signature.
pub fn orthonormal(positive: usize, negative: usize, null: usize) -> Metric {
    Metric::from_signature(positive, negative, null).unwrap()
}

/// R4_1 with n_o and n_∞, n_o·n_∞ = −1, instead of two vectors of square ±1.
pub fn conformal() -> Metric {
    let mut gram = vec![vec![Rational::ZERO; 5]; 5];
    for (index, row) in gram.iter_mut().take(3).enumerate() {
        row[index] = Rational::ONE;
    }
    gram[3][4] = -Rational::ONE;
    gram[4][3] = -Rational::ONE;
    Metric::new(["e1", "e2", "e3", "no", "ni"], gram).unwrap()
}

/// A metric that no preset covers.
pub fn oblique() -> Metric {
    let gram = vec![
        vec![fraction(2, 1), fraction(1, 1), fraction(0, 1)],
        vec![fraction(1, 1), fraction(-1, 1), fraction(1, 2)],
        vec![fraction(0, 1), fraction(1, 2), fraction(3, 1)],
    ];
    Metric::new(["a", "b", "c"], gram).unwrap()
}

/// A degenerate metric whose null direction is no basis vector: (a − b)·x = 0 for all x.
pub fn oblique_degenerate() -> Metric {
    let gram = vec![
        vec![fraction(1, 1), fraction(1, 1), fraction(2, 1)],
        vec![fraction(1, 1), fraction(1, 1), fraction(2, 1)],
        vec![fraction(2, 1), fraction(2, 1), fraction(-1, 1)],
    ];
    Metric::new(["a", "b", "c"], gram).unwrap()
}

/// Every metric of the catalogue with its name.
pub fn all() -> Vec<(&'static str, Metric)> {
    vec![
        ("R0", orthonormal(0, 0, 0)),
        ("R2", orthonormal(2, 0, 0)),
        ("R3", orthonormal(3, 0, 0)),
        ("R0_2", orthonormal(0, 2, 0)),
        ("R3_0_1", orthonormal(3, 0, 1)),
        ("R1_3", orthonormal(1, 3, 0)),
        ("R4_1", orthonormal(4, 1, 0)),
        ("conformal", conformal()),
        ("oblique", oblique()),
        ("oblique degenerate", oblique_degenerate()),
        ("R3_3", orthonormal(3, 3, 0)),
        ("R4_2", orthonormal(4, 2, 0)),
        ("R2_4", orthonormal(2, 4, 0)),
        ("R6", orthonormal(6, 0, 0)),
    ]
}
