//! Products of dense elements as products of matrices: the algebra is isomorphic to one of
//! matrices over the reals, the complex numbers or the quaternions.
//!
//! The code generator finds commuting blades g₁ … g_k of square 1, and for each but those that
//! commute with everything an element h that anticommutes with it and commutes with the other
//! ones. What commutes with all of them is ℝ, ℂ or ℍ. Then
//!
//! ```text
//! X = Σ x_{a,b,c} g^a h^b κ^c   has the matrix   M[r][r ⊕ b] = Σ_c κ^c Σ_a (−1)^{a·r} x_{a,b,c}
//! ```
//!
//! with bit vectors a, b, r: the rows belong to the idempotents Π (1 ± g)/2. The sum over a is a
//! Walsh–Hadamard transform. Blades g that commute with everything split the algebra into ideals,
//! so that the matrices fall into blocks. A vector of square zero is an outer unit ε:
//! (A + εB)(C + εD) = AC + ε(BC + ÂD).
//!
//! Of a pair of null vectors u, v with u·v = γ = ±1, g is γ u∧v, and u and γv are the units
//! above and below the diagonal, up to a factor 2: they are copied, not mixed. So elements of
//! different conformal weight never meet in a sum.
//!
//! **Rounding.** Coefficients that vanish exactly in the direct product are here differences of
//! equal sums: rounding noise relative to the largest coefficients of the operands. An infinity
//! or a NaN in one coefficient spoils many of the result.

mod kernel;
mod tables;

pub use tables::{Isomorphism, Term};
