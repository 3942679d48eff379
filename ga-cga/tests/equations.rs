//! Every equation of chapter 2 of the dissertation that states a result, every row of its
//! Table 2.6 and the algorithms of chapter 2 and appendix A, each by its number.
//!
//! Algebraic statements are tested on exact rationals, transcendental ones on floats with the
//! tolerance that the test states. Where the print is wrong, the test holds the right form and
//! says so.
//!
//! No number from (2.1) to (2.71) is left out: (2.9), the Kronecker delta, states no result and
//! stands with (2.8), which uses it, and (2.15) repeats (2.7).

#[path = "equations/appendix_a.rs"]
mod appendix_a;
#[path = "equations/conformal_metric.rs"]
mod conformal_metric;
#[path = "equations/direct.rs"]
mod direct;
#[path = "equations/dual.rs"]
mod dual;
#[path = "equations/duality.rs"]
mod duality;
#[path = "equations/euclidean.rs"]
mod euclidean;
#[path = "equations/figures.rs"]
mod figures;
#[path = "equations/geometric_product.rs"]
mod geometric_product;
#[path = "equations/interpolation.rs"]
mod interpolation;
#[path = "equations/notation.rs"]
mod notation;
#[path = "equations/points.rs"]
mod points;
#[path = "equations/ratios.rs"]
mod ratios;
#[path = "equations/rounds.rs"]
mod rounds;
#[path = "equations/samples.rs"]
mod samples;
#[path = "equations/table_2_6_elements.rs"]
mod table_2_6_elements;
#[path = "equations/table_2_6_transformations.rs"]
mod table_2_6_transformations;
#[path = "equations/transformations.rs"]
mod transformations;
#[path = "equations/versors.rs"]
mod versors;
