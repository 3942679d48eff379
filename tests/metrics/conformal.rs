//! The conformal model's metric, written by hand: what its generated code is compared with.

use ga::core::{Metric, Rational};

/// The Euclidean vectors, then n_o and n_∞ with n_o·n_∞ = −1.
pub fn null_basis() -> Metric {
    let gram = [
        [1, 0, 0, 0, 0],
        [0, 1, 0, 0, 0],
        [0, 0, 1, 0, 0],
        [0, 0, 0, 0, -1],
        [0, 0, 0, -1, 0],
    ];
    let gram = gram.map(|row| row.map(Rational::from).to_vec()).to_vec();
    Metric::new(["e1", "e2", "e3", "no", "ni"], gram).expect("symmetric")
}
