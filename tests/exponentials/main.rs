//! Exponentials, logarithms, square roots, polar normalisation and splits in every kind of metric
//! of up to five dimensions, and the iterated ones in six.

mod accuracy;
mod conformal;
mod families;
mod indefinite;
mod iterated;
#[path = "../metrics/conformal.rs"]
mod metrics;
mod normalisation;
mod numbers;
mod refusals;
mod six_dimensions;
mod space;
mod splits;
mod wide;

use ga::cga::cga3;
use ga::core::{Metric, Rational};

use crate::accuracy::{check, check_series, check_single};
use crate::metrics::null_basis;
use crate::space::Space;

ga::define_algebra!(R2);
ga::define_algebra!(R3);
ga::define_algebra!(R0_2);
ga::define_algebra!(R0_3);
ga::define_algebra!(R2_0_1);
ga::define_algebra!(R4);
ga::define_algebra!(R3_0_1);
ga::define_algebra!(R1_3);
ga::define_algebra!(R3_1);
ga::define_algebra!(R2_2);
ga::define_algebra!(R2_0_2);
ga::define_algebra!(R5);
ga::define_algebra!(R4_1);

ga::define_algebra! {
    /// Four oblique vectors.
    pub mod oblique: R3_1 {
        basis { a, b, c, d }
        metric { a^2 = 2, b^2 = 3, c^2 = 2, d^2 = -2, a.b = 1, b.c = 1, c.d = 1 }
        types { Bivector = grade 2; }
    }
}

ga::define_algebra! {
    /// The same without a type of its bivectors alone.
    pub mod untyped: R3_1 {
        basis { a, b, c, d }
        metric { a^2 = 2, b^2 = 3, c^2 = 2, d^2 = -2, a.b = 1, b.c = 1, c.d = 1 }
        types {}
    }
}

/// The geometry of a signature.
pub fn space(name: &'static str, p: usize, q: usize, r: usize) -> Space {
    let metric = Metric::from_signature(p, q, r).expect("few dimensions");
    Space::new(name, &metric, &[])
}

/// The geometry of four oblique vectors.
fn four_oblique() -> Space {
    let gram = [[2, 1, 0, 0], [1, 3, 1, 0], [0, 1, 2, 1], [0, 0, 1, -2]];
    let gram = gram.map(|row| row.map(Rational::from).to_vec());
    let metric = Metric::new(["a", "b", "c", "d"], gram.to_vec()).expect("symmetric");
    Space::new("oblique", &metric, &[])
}

/// The conformal model in its null basis.
pub fn conformal_space() -> Space {
    let frame: [&[f64]; 5] = [
        &[1.0, 0.0, 0.0, 0.0, 0.0],
        &[0.0, 1.0, 0.0, 0.0, 0.0],
        &[0.0, 0.0, 1.0, 0.0, 0.0],
        &[0.0, 0.0, 0.0, 1.0, -0.5],
        &[0.0, 0.0, 0.0, 1.0, 0.5],
    ];
    Space::new("cga3", &null_basis(), &frame)
}

#[test]
fn two_dimensions() {
    check::<r2::Bivector, r2::Even>(&space("R2", 2, 0, 0));
    check::<r0_2::Bivector, r0_2::Even>(&space("R0_2", 0, 2, 0));
}

#[test]
fn three_dimensions() {
    check::<r3::Bivector, r3::Even>(&space("R3", 3, 0, 0));
    check::<r0_3::Bivector, r0_3::Even>(&space("R0_3", 0, 3, 0));
    check::<r2_0_1::Bivector, r2_0_1::Even>(&space("R2_0_1", 2, 0, 1));
}

#[test]
fn four_dimensions() {
    check::<r4::Bivector, r4::Even>(&space("R4", 4, 0, 0));
    check::<r1_3::Bivector, r1_3::Even>(&space("R1_3", 1, 3, 0));
    check::<r3_1::Bivector, r3_1::Even>(&space("R3_1", 3, 1, 0));
    check::<r2_2::Bivector, r2_2::Even>(&space("R2_2", 2, 2, 0));
}

#[test]
fn four_dimensions_that_are_not_orthonormal() {
    check::<r3_0_1::Bivector, r3_0_1::Even>(&space("R3_0_1", 3, 0, 1));
    check::<r2_0_2::Bivector, r2_0_2::Even>(&space("R2_0_2", 2, 0, 2));
    check::<oblique::Bivector, oblique::Even>(&four_oblique());
    check_series::<untyped::Even, untyped::Even>(&four_oblique());
}

#[test]
fn five_dimensions() {
    check::<r5::Bivector, r5::Even>(&space("R5", 5, 0, 0));
    check::<r4_1::Bivector, r4_1::Even>(&space("R4_1", 4, 1, 0));
}

#[test]
fn the_null_basis() {
    check::<cga3::PointPair, cga3::Even>(&conformal_space());
    check::<cga3::DualLine, cga3::Motor>(&conformal_space());
}

#[test]
fn single_precision() {
    check_single::<r3::Bivector<f32>, r3::Even<f32>>(&space("R3", 3, 0, 0));
    check_single::<r4::Bivector<f32>, r4::Even<f32>>(&space("R4", 4, 0, 0));
    check_single::<r1_3::Bivector<f32>, r1_3::Even<f32>>(&space("R1_3", 1, 3, 0));
    check_single::<r3_0_1::Bivector<f32>, r3_0_1::Even<f32>>(&space("R3_0_1", 3, 0, 1));
    check_single::<cga3::PointPair<f32>, cga3::Even<f32>>(&conformal_space());
    check_single::<cga3::DualLine<f32>, cga3::Motor<f32>>(&conformal_space());
}
