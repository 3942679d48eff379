//! Six dimensions: logarithms and square roots by inverse scaling and squaring, against the
//! oracle's exponentials.

use std::f64::consts::PI;

use ga::core::Real;
use ga::core::ops::{Element, Logarithm, SquareRoot};

use crate::families::Random;
use crate::six_dimensions::{r2_4, r3_3, r4_2, r6};
use crate::space;
use crate::space::{Space, Value, error, times};
use crate::wide::Wide;

/// Three ways to pair six axes.
const PAIRINGS: [[[usize; 2]; 3]; 3] = [
    [[0, 1], [2, 3], [4, 5]],
    [[0, 5], [1, 4], [2, 3]],
    [[0, 3], [1, 5], [2, 4]],
];
/// Sizes of the three planes: as turns they add up to less than 2.9.
const SIZES: [[f64; 3]; 8] = [
    [0.0, 0.0, 0.0],
    [1e-200, 0.0, 0.0],
    [1e-8, 1e-4, 0.3],
    [2.9, 0.0, 0.0],
    [1.5, 1.0, 0.3],
    [0.9, -0.9, 0.9],
    [1.0, 1.0, -1e-9],
    [-2.0, 0.5, 0.2],
];

fn sum(space: &Space, terms: &[(f64, Value)]) -> Value {
    terms
        .iter()
        .fold(space.algebra.zero(), |sum, (size, blade)| {
            let term = blade.scale(Wide::from(*size));
            sum.add(&term).expect("the same algebra")
        })
}

/// The bivector turned by a versor that is not far from 1.
fn turned(space: &Space, bivector: &Value, random: &mut Random) -> Value {
    let mut generator = space.algebra.zero();
    for i in 0..6 {
        for j in 0..i {
            let blade = times(&space.frame[i], &space.frame[j]);
            let term = blade.scale(Wide::from(0.15 * random.number()));
            generator = generator.add(&term).expect("the same algebra");
        }
    }
    let versor = space.exp(&generator);
    let image = space.times(&space.times(&versor, bivector), &versor.reverse());
    image.grade(2)
}

/// Logarithm and root of the exponential of a bivector that is principal.
fn agrees<R>(space: &Space, bivector: &Value, allowed: f64)
where
    R: Element<Number: Real + Into<f64>>
        + Logarithm<Output: Element<Number: Into<f64>>>
        + SquareRoot<Output: Element<Number: Into<f64>>>,
{
    let versor: R = space.rounded(&space.exp(bivector));
    let near = |found: &Value, expected: &Value, what: &str| {
        let miss = error(found, expected);
        assert!(
            miss <= allowed,
            "{what} of {bivector:?} in {}: {miss:e}",
            space.name
        );
    };
    let log = versor.log().expect("a principal logarithm");
    near(&space.value(&log), bivector, "log");
    let root = space.value(&versor.sqrt().expect("a principal root"));
    let half = space.exp(&bivector.scale(Wide::from(0.5)));
    near(&root, &half, "sqrt");
    near(&space.times(&root, &root), &space.value(&versor), "sqrt²");
}

fn principal<R>(space: &Space)
where
    R: Element<Number = f64>
        + Logarithm<Output: Element<Number = f64>>
        + SquareRoot<Output: Element<Number = f64>>,
{
    let mut random = Random::new(29);
    for pairing in PAIRINGS {
        for sizes in SIZES {
            let planes: Vec<(f64, Value)> = pairing
                .iter()
                .zip(sizes)
                .map(|(&[i, j], size)| (size, times(&space.frame[i], &space.frame[j])))
                .collect();
            let bivector = sum(space, &planes);
            agrees::<R>(space, &bivector, 1e-12);
            agrees::<R>(space, &turned(space, &bivector, &mut random), 1e-12);
        }
    }
}

#[test]
fn three_commuting_planes() {
    principal::<r6::Even>(&space("R6", 6, 0, 0));
    principal::<r4_2::Even>(&space("R4_2", 4, 2, 0));
    principal::<r3_3::Even>(&space("R3_3", 3, 3, 0));
    principal::<r2_4::Even>(&space("R2_4", 2, 4, 0));
}

#[test]
fn null_planes() {
    let space = space("R4_2", 4, 2, 0);
    let frame = &space.frame;
    let null =
        |i: usize, j: usize| sum(&space, &[(1.0, frame[i].clone()), (1.0, frame[j].clone())]);
    let translation = times(&null(0, 4), &frame[2]);
    let other = times(&null(0, 4), &null(1, 5));
    let turn = times(&frame[2], &frame[3]);
    for size in [1e-9, 0.4, 3.0, 70.0] {
        // Long translations take many roots, and their rounding is doubled as often.
        let allowed = 1e-12 * f64::max(1.0, size);
        agrees::<r4_2::Even>(
            &space,
            &sum(&space, &[(size, translation.clone())]),
            allowed,
        );
        agrees::<r4_2::Even>(&space, &sum(&space, &[(size, other.clone())]), allowed);
        let both = sum(&space, &[(size, other.clone()), (2.5, turn.clone())]);
        agrees::<r4_2::Even>(&space, &both, allowed);
    }
}

#[test]
fn near_the_edge() {
    let space = space("R6", 6, 0, 0);
    let plane = times(&space.frame[0], &space.frame[1]);
    for gap in [1e-2, 1e-4, 1e-6] {
        let bivector = sum(&space, &[(PI - gap, plane.clone())]);
        agrees::<r6::Even>(&space, &bivector, 1e-15 / gap + 1e-13);
    }
}

#[test]
fn single_precision() {
    let space = space("R6", 6, 0, 0);
    let plane = |i: usize, j: usize| times(&space.frame[i], &space.frame[j]);
    let bivector = sum(
        &space,
        &[(1.2, plane(0, 1)), (0.7, plane(2, 3)), (-0.4, plane(4, 5))],
    );
    agrees::<r6::Even<f32>>(&space, &bivector, 1e-5);
}

/// The norm is no part of the logarithm, and has its root in the root.
#[test]
fn versors_of_other_norms() {
    let bivector = r6::Bivector::from_fn(|i| 0.3 - 0.04 * i as f64);
    let versor = bivector.exp();
    for norm in [1e-60, 0.25, 9.0, 1e40] {
        let log = (versor * norm).log().expect("a principal logarithm");
        assert!((log - bivector).norm() < 1e-13);
        let root = (versor * norm).sqrt().expect("a principal root");
        let miss = (root * root - versor * norm).to_array();
        assert!(miss.iter().all(|x| f64::abs(*x) < 1e-13 * norm));
    }
    // Rounding of a long product is drift, not another element.
    let drifted = versor.map(|x: f64| x * (1.0 + 1e-11 * (1e3 * x).sin()));
    let log = drifted.log().expect("nearly a versor");
    assert!((log - bivector).norm() < 1e-9);
}

fn refuses<R>(element: R, why: &str)
where
    R: Element<Number = f64> + Logarithm + SquareRoot,
{
    assert!(element.log().is_none(), "log: {why}");
    assert!(element.sqrt().is_none(), "sqrt: {why}");
}

/// The element with these coefficients at blades of the orthonormal basis.
fn even<R: Element<Number = f64>>(terms: &[(u32, f64)]) -> R {
    R::from_fn(|i| {
        let (blade, sign) = R::BLADES[i];
        let own = terms.iter().filter(|(mask, _)| *mask == blade.mask());
        own.map(|(_, value)| value * f64::from(sign)).sum()
    })
}

#[test]
fn what_has_no_principal_logarithm_has_none() {
    refuses(even::<r6::Even>(&[(0, -1.0)]), "−1 is in every plane");
    refuses(even::<r3_3::Even>(&[(0, -1.0)]), "−1 is in every plane");
    refuses(even::<r6::Even>(&[(0b1111, 1.0)]), "two right angles");
    refuses(even::<r6::Even>(&[(0b11_1111, 1.0)]), "three right angles");
    // Turns that add up to more than π.
    let sum = even::<r6::Bivector>(&[(0b11, 1.2), (0b1100, 1.2), (0b11_0000, 1.2)]);
    refuses(sum.exp(), "3.6 is more than π");
    // Minus a boost, minus a translation, and both with a turn in another plane.
    let boost = even::<r4_2::Bivector>(&[(0b01_0001, 0.7)]);
    refuses(-boost.exp(), "minus a boost");
    let null = even::<r4_2::Bivector>(&[(0b11, 0.7), (0b01_0010, 0.7)]);
    refuses(-null.exp(), "minus a null versor");
    let boosts = even::<r3_3::Bivector>(&[(0b00_1001, 0.7), (0b01_0010, 0.4), (0b10_0100, 1.0)]);
    assert!(boosts.exp().log().is_some());
    refuses(-boosts.exp(), "minus three boosts");
}

#[test]
fn what_is_no_versor_has_none() {
    refuses(r6::Even::default(), "zero");
    refuses(
        even::<r6::Even>(&[(0, 1.0), (0b1111, 0.5)]),
        "R R̃ is no number",
    );
    // R R̃ = 1, but vectors do not stay vectors.
    let (sin, cos) = 0.5_f64.sin_cos();
    refuses(
        even::<r6::Even>(&[(0, cos), (0b11_1111, sin)]),
        "six-vector",
    );
    refuses(even::<r4_2::Even>(&[(0, 1.0), (0b01_0001, 3.0)]), "R R̃ < 0");
    refuses(even::<r4_2::Even>(&[(0, 1.0), (0b01_0001, 1.0)]), "R R̃ = 0");
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e200, f64::MAX] {
        for index in [0, 1, 7, 20, 31] {
            let element = r6::Even::from_fn(|i| if i == index { bad } else { 0.5 });
            refuses(element, "not finite or too large");
        }
    }
}

/// Whatever the element, what is returned is finite.
#[test]
fn every_answer_is_finite() {
    const SIZES: [f64; 9] = [0.0, 5e-324, 1e-155, 1e-16, 1.0, 1.0, 1e8, 1e77, 1.7e308];
    let mut random = Random::new(8);
    for round in 0..200 {
        let mut number = |share: usize| match (round + share) % 5 {
            0 => random.number().round(),
            1 => SIZES[(random.number().abs() * 9.0) as usize % 9],
            2 => random.number(),
            _ => 0.0,
        };
        let element = r4_2::Even::from_fn(&mut number);
        if let Some(log) = element.log() {
            assert!(log.to_array().into_iter().all(f64::is_finite));
        }
        let sparse = r3_3::Bivector::from_fn(&mut number).map(|x| x % 1e3).exp();
        if let Some(root) = sparse.sqrt() {
            assert!(root.to_array().into_iter().all(f64::is_finite));
        }
    }
}
