//! Versors of the conformal model whose norm squared is negative, and versors at the edge of the
//! principal logarithm.

use std::f64::consts::{FRAC_PI_2, PI};

use ga::cga::cga3;
use ga::core::Blade;
use ga::core::ops::Element;

use crate::conformal_space;
use crate::families::Random;
use crate::space::{error, times};
use crate::wide::Wide;

/// Products of four vectors: `V Ṽ` is the product of their squares.
#[test]
fn versors_of_negative_norm_have_no_polar_factor() {
    let space = conformal_space();
    let mut random = Random::new(41);
    let mut counts = [0, 0];
    while counts[0] < 200 || counts[1] < 200 {
        let mut product = space.algebra.scalar(Wide::from(1.0));
        let mut square = 1.0;
        for _ in 0..4 {
            let mut vector = space.algebra.zero();
            for own in &space.frame {
                let term = own.scale(Wide::from(random.number()));
                vector = vector.add(&term).expect("the same algebra");
            }
            square *= times(&vector, &vector).coefficient(Blade::SCALAR).to_f64();
            product = times(&product, &vector);
        }
        if square.abs() < 1e-3 {
            continue;
        }
        let versor: cga3::Even = space.rounded(&product);
        counts[usize::from(square > 0.0)] += 1;
        match versor.renormalized() {
            Some(unit) => {
                assert!(square > 0.0, "V Ṽ = {square}");
                let expected = product.scale(Wide::from(square.sqrt().recip()));
                assert!(error(&space.value(&unit), &expected) < 1e-11);
            }
            None => assert!(square < 0.0, "V Ṽ = {square}"),
        }
        if square < 0.0 {
            assert!(versor.log().is_none() && versor.sqrt().is_none());
        }
    }
}

#[test]
fn minus_a_hyperbolic_rotor_has_no_logarithm() {
    for size in [1e-9, 1e-3, 0.7, 3.0, 8.0] {
        let pair = cga3::PointPair::from(cga3::MinkowskiPlane::new(size));
        assert!(pair.exp().log().is_some());
        assert!((-pair.exp()).log().is_none(), "{size}");
        assert!((-pair.exp()).sqrt().is_none(), "{size}");
        // The same beside a turn: minus both is a turn by π less, so it has one.
        let turn = cga3::PointPair::from(cga3::DualLine::new(1.0, 0.0, 0.0, 0.0, 0.0, 0.0));
        let both = (pair + turn).exp();
        let log = (-both).log().expect("turned by 1 − π");
        let expected = pair + turn * (1.0 - PI);
        let miss = (log - expected).to_array();
        assert!(
            miss.iter().all(|x| f64::abs(*x) < 1e-9 * (1.0 + size)),
            "{size}"
        );
    }
}

/// Two equal turns: unique up to a right angle, where the planes are left open.
#[test]
fn isoclinic_versors() {
    for turn in [1e-6, 0.4, 1.2, FRAC_PI_2 - 1e-4] {
        let bivector = crate::r4::Bivector::from_fn(|i| {
            let mask = crate::r4::Bivector::<f64>::BLADES[i].0.mask();
            if mask == 0b0011 || mask == 0b1100 {
                turn
            } else {
                0.0
            }
        });
        let versor = bivector.exp();
        let log = versor.log().expect("principal");
        assert!((log - bivector).norm() < 1e-10, "{turn}");
        let root = versor.sqrt().expect("principal");
        let miss = (root * root - versor).to_array();
        assert!(miss.iter().all(|x| f64::abs(*x) < 1e-10), "{turn}");
    }
    let pseudoscalar = crate::r4::Even::new(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0);
    assert!(pseudoscalar.log().is_none() && pseudoscalar.sqrt().is_none());
}
