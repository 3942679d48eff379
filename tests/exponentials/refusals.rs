//! What has no logarithm or root says so; nothing panics and nothing is not a number.

use std::f64::consts::PI;

use ga::cga::cga3;
use ga::core::ops::{Element, Logarithm, Renormalize, SplitCommuting, SquareRoot};

use crate::families::Random;
use crate::{r1_3, r2_2, r3_0_1, r4, r4_1, r5};

/// No logarithm and no root.
fn refuses<R>(versor: R)
where
    R: Element<Number = f64> + Logarithm<Output: PartialEq> + SquareRoot<Output: PartialEq>,
{
    let coefficients: Vec<f64> = (0..R::BLADES.len()).map(|i| versor.at(i)).collect();
    assert!(versor.log().is_none(), "log of {coefficients:?}");
    assert!(versor.sqrt().is_none(), "sqrt of {coefficients:?}");
}

/// The element of one coefficient.
fn unit<R: Element<Number = f64>>(index: usize) -> R {
    R::from_fn(|i| if i == index { 1.0 } else { 0.0 })
}

#[test]
fn minus_one_is_not_unique() {
    refuses(-unit::<r4::Even>(0));
    refuses(-unit::<r5::Even>(0));
    refuses(-unit::<r1_3::Even>(0));
    refuses(-unit::<r3_0_1::Even>(0));
    refuses(-unit::<r4_1::Even>(0));
    refuses(-unit::<cga3::Motor>(0));
    refuses(-unit::<cga3::Even>(0));
    // Both planes turn by a right angle, and which planes is left open.
    refuses(unit::<r4::Even>(7));
    refuses(-unit::<r4::Even>(7));
}

/// The rounding of grade 4 must not choose one of the many planes that commute with the boost.
#[test]
fn rounding_does_not_choose_a_logarithm() {
    let mut random = Random::new(53);
    for _ in 0..2_000 {
        let mut point = || {
            let [x, y, z] = [(); 3].map(|()| 2.0 * random.number());
            cga3::Point::new(x, y, z, (x * x + y * y + z * z) / 2.0)
        };
        let (from, to) = (point(), point());
        let Some(pair) = from.wedge(to).normalized() else {
            continue;
        };
        for size in [0.05, 0.3, 1.0, 3.0] {
            let boost = (pair * size).exp();
            assert!(boost.log().is_some() && boost.sqrt().is_some());
            refuses(-boost);
        }
    }
}

#[test]
fn minus_a_boost_or_a_null_versor_has_none() {
    let boost = r1_3::Bivector::from([0.7, 0.2, 0.0, 0.0, 0.0, 0.0]).exp();
    refuses(-boost);
    let null = r1_3::Bivector::from([0.7, 0.0, 0.7, 0.0, 0.0, 0.0]);
    assert!(f64::abs(null.exp().s - 1.0) < 1e-15);
    refuses(-null.exp());
    refuses(-cga3::DualLine::from([0.0, 0.0, 0.0, 1.0, 2.0, 3.0]).exp());
    refuses(-cga3::PointPair::from(cga3::MinkowskiPlane::new(2.0)).exp());
    refuses(-cga3::PointPair::from(cga3::TangentVector::new(1.0, 2.0, 3.0)).exp());
    // One of the two components of R2,2 is minus a boost.
    let double = r2_2::Bivector::from([0.0, 0.9, 0.0, 0.0, 0.9, 0.0]);
    let rotation = r2_2::Bivector::from([PI, 0.0, 0.0, 0.0, 0.0, 0.0]);
    assert!(double.exp().log().is_some());
    refuses(-double.exp());
    assert!(
        rotation
            .exp()
            .log()
            .is_none_or(|log| log.to_array().iter().all(|x| x.is_finite()))
    );
}

#[test]
fn what_is_no_versor_has_none() {
    // R R̃ has a part of grade four.
    refuses(r4::Even::new(1.0, 0.5, 0.0, 0.0, 0.0, 0.0, 0.5, 0.0));
    // R R̃ is zero or negative.
    refuses(r1_3::Even::new(1.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0));
    refuses(r1_3::Even::new(1.0, 3.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0));
    refuses(r4::Even::default());
    refuses(cga3::Motor::default());
    refuses(cga3::Even::default());
    // The parts of grade two and four do not commute, in five dimensions only.
    let bivector = r5::Even::from(r5::Bivector::from_fn(|i| if i == 0 { 0.6 } else { 0.0 }));
    for index in 0..5 {
        let fourth = r5::Quadvector::from_fn(|i| if i == index { 0.8 } else { 0.0 });
        let sum = bivector + r5::Even::from(fourth);
        let product = sum * sum.reverse();
        let is_versor = (product - r5::Even::from(r5::Scalar::new(1.0))).to_array();
        if is_versor.iter().any(|x| f64::abs(*x) > 1e-9) {
            refuses(sum);
        }
    }
}

#[test]
fn what_is_not_finite_has_none() {
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e200] {
        for index in 0..8 {
            let value = |i: usize| if i == index { bad } else { 0.5 };
            refuses(r4::Even::from_fn(value));
            refuses(r3_0_1::Even::from_fn(value));
            refuses(r1_3::Even::from_fn(value));
            refuses(cga3::Motor::from_fn(value));
            refuses(cga3::Even::from_fn(value));
        }
    }
}

/// Every answer of random values of all sizes is finite.
fn finite_answers<B, R>(seed: u64)
where
    B: Element<Number = f64> + SplitCommuting<Output: Element<Number = f64>>,
    R: Element<Number = f64>
        + Logarithm<Output: Element<Number = f64>>
        + SquareRoot<Output: Element<Number = f64>>
        + Renormalize<Output: Element<Number = f64>>,
{
    fn check<X: Element<Number = f64>>(value: Option<X>) {
        if let Some(value) = value {
            let all: Vec<f64> = (0..X::BLADES.len()).map(|i| value.at(i)).collect();
            assert!(all.iter().all(|x| x.is_finite()), "{all:?}");
        }
    }
    const SIZES: [f64; 12] = [
        0.0, 5e-324, 1e-300, 1e-155, 1e-77, 1e-16, 1.0, 1.0, 1e8, 1e77, 1e155, 1.7e308,
    ];
    let mut random = Random::new(seed);
    for round in 0..20_000 {
        let mut number = || {
            let size = SIZES[(random.number().abs() * 12.0) as usize % 12];
            match round % 4 {
                0 => random.number(),
                1 => random.number().round(),
                2 => size,
                _ => random.number() * size,
            }
        };
        let versor = R::from_fn(|_| number());
        check(versor.log());
        check(versor.sqrt());
        check(versor.renormalized());
        let bivector = B::from_fn(|_| number());
        for blade in bivector.split_commuting().blades().into_iter().flatten() {
            check(Some(blade));
        }
    }
}

#[test]
fn every_answer_is_finite() {
    finite_answers::<r4::Bivector, r4::Even>(1);
    finite_answers::<r1_3::Bivector, r1_3::Even>(2);
    finite_answers::<r2_2::Bivector, r2_2::Even>(3);
    finite_answers::<r3_0_1::Bivector, r3_0_1::Even>(4);
    finite_answers::<r4_1::Bivector, r4_1::Even>(5);
    finite_answers::<cga3::PointPair, cga3::Even>(6);
    finite_answers::<cga3::DualLine, cga3::Motor>(7);
}

#[test]
fn huge_angles_have_unit_exponentials() {
    for size in [1e3, 1e8, 1e16, 1e60] {
        let bivector = r4::Bivector::from([1.0, 0.2, -0.4, 0.7, 0.1, 0.5]) * size;
        let versor = bivector.exp();
        let norm = versor.norm();
        assert!(f64::abs(norm - 1.0) < 1e-14, "{size:e}: {norm}");
        let line = cga3::DualLine::from([1.0, 0.2, -0.4, 0.7, 0.1, 0.5]) * size;
        assert!(f64::abs(line.exp().norm() - 1.0) < 1e-14);
    }
}
