//! Exponentials, logarithms, square roots, polar normalisation and splits in every kind of metric
//! of up to five dimensions, and exponentials in six.

mod accuracy;
mod families;
mod space;
mod wide;

use ga::cga::cga3;
use ga::core::{Metric, Rational};

use crate::accuracy::check;
use crate::space::Space;

ga::define_algebra!(R4);
ga::define_algebra!(R5);
ga::define_algebra!(R3_0_1);
ga::define_algebra!(R1_3);
ga::define_algebra!(R3_1);
ga::define_algebra!(R4_1);
ga::define_algebra!(R2_2);
ga::define_algebra!(R3);

fn space(name: &'static str, p: usize, q: usize, r: usize) -> Space {
    let metric = Metric::from_signature(p, q, r).expect("few dimensions");
    Space::new(name, &metric, &[])
}

/// The conformal model in its null basis.
fn conformal() -> Space {
    let gram = [
        [1, 0, 0, 0, 0],
        [0, 1, 0, 0, 0],
        [0, 0, 1, 0, 0],
        [0, 0, 0, 0, -1],
        [0, 0, 0, -1, 0],
    ];
    let gram = gram.map(|row| row.map(Rational::from).to_vec()).to_vec();
    let metric = Metric::new(["e1", "e2", "e3", "no", "ni"], gram).expect("symmetric");
    let frame: [&[f64]; 5] = [
        &[1.0, 0.0, 0.0, 0.0, 0.0],
        &[0.0, 1.0, 0.0, 0.0, 0.0],
        &[0.0, 0.0, 1.0, 0.0, 0.0],
        &[0.0, 0.0, 0.0, 1.0, -0.5],
        &[0.0, 0.0, 0.0, 1.0, 0.5],
    ];
    Space::new("cga3", &metric, &frame)
}

#[test]
fn three_dimensions() {
    check::<r3::Bivector, r3::Even>(&space("R3", 3, 0, 0));
}

#[test]
fn four_dimensions() {
    check::<r4::Bivector, r4::Even>(&space("R4", 4, 0, 0));
    check::<r1_3::Bivector, r1_3::Even>(&space("R1_3", 1, 3, 0));
    check::<r3_1::Bivector, r3_1::Even>(&space("R3_1", 3, 1, 0));
    check::<r3_0_1::Bivector, r3_0_1::Even>(&space("R3_0_1", 3, 0, 1));
    check::<r2_2::Bivector, r2_2::Even>(&space("R2_2", 2, 2, 0));
}

#[test]
fn five_dimensions() {
    check::<r5::Bivector, r5::Even>(&space("R5", 5, 0, 0));
    check::<r4_1::Bivector, r4_1::Even>(&space("R4_1", 4, 1, 0));
}

#[test]
fn the_null_basis() {
    check::<cga3::PointPair, cga3::Even>(&conformal());
    check::<cga3::DualLine, cga3::Motor>(&conformal());
}
