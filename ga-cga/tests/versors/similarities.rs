//! Scalings, transversions and general similarities (2.4.4), against plain vector geometry.

use crate::random::Random;
use ga_cga::{Dilator, Even, MinkowskiPlane, Point, Transversor, Vector3};

/// e^{−cE/2} scales by e^{−c}; a factor f is any number but zero.
#[test]
fn dilators_scale_about_the_origin() {
    let mut random = Random::new(21);
    for _ in 0..1000 {
        let (factor, p) = (random.number() * 5.0, random.point());
        let dilator = Dilator::scaling(factor).expect("not zero");
        assert!(((dilator.s - dilator.noni) * (dilator.s + dilator.noni)).abs() - 1.0 < 1e-12);
        let image = p.image_under(dilator).expect("a point");
        assert!((image.position() - p.position() * factor).norm() < 1e-13);
        assert!((dilator.factor().expect("a factor") - factor).abs() < 1e-13);
        let c = random.number() * 3.0;
        let exponential: Dilator = (MinkowskiPlane::new(1.0) * (-c / 2.0)).exp();
        assert!((exponential - Dilator::scaling((-c).exp()).expect("positive")).norm() < 1e-12);
    }
    let nearly_one = Dilator::scaling(1.0_f64 + 1e-9).expect("not zero");
    let nearly_one = nearly_one.factor().expect("a factor");
    assert!((nearly_one - (1.0 + 1e-9)).abs() < 1e-15);
    for factor in [0.0, f64::INFINITY, f64::NAN] {
        assert_eq!(Dilator::scaling(factor), None);
    }
    assert_eq!(Dilator::new(1.0, 1.0).factor(), None);
}

#[test]
fn scalings_about_a_point_keep_it() {
    let mut random = Random::new(22);
    for _ in 0..1000 {
        let (center, p) = (random.point(), random.point());
        let factor = random.number() * 3.0;
        let scaling = Even::scaling(center, factor).expect("not zero");
        let image = p.image_under(scaling).expect("a point");
        let expected = center.position() + (p.position() - center.position()) * factor;
        assert!((image.position() - expected).norm() < 1e-12);
        assert!(
            center
                .image_under(scaling)
                .expect("a point")
                .distance(center)
                < 1e-12
        );
    }
    assert_eq!(Even::scaling(Point::at(1.0, 2.0, 3.0), 0.0), None);
}

/// 1 − ½ v n_o maps x to inv(inv(x) + v/2).
#[test]
fn transversors_translate_between_inversions() {
    let mut random = Random::new(23);
    let inverse = |x: Vector3| x / x.norm_squared();
    for _ in 0..1000 {
        let (v, p) = (random.vector(), random.point());
        let bend = Transversor::by(v);
        assert!((bend.vector() - v).norm() < 1e-15);
        let middle = inverse(p.position()) + v / 2.0;
        if middle.norm() < 1e-2 {
            continue;
        }
        let image = p.image_under(bend).expect("not sent to infinity");
        let expected = inverse(middle);
        assert!((image.position() - expected).norm() < 1e-11 * (1.0 + expected.norm()));
        let twice: Transversor = bend * bend;
        assert!((twice.vector() - v * 2.0).norm() < 1e-14);
    }
    let origin = Point::at(0.0, 0.0, 0.0);
    let bend = Transversor::by(Vector3::new(1.0, 2.0, 3.0));
    assert_eq!(origin.image_under(bend), Some(origin));
}

/// Every similarity falls into its parts again, whatever the sign and weight of the versor.
#[test]
fn similarities_fall_into_their_parts() {
    let mut random = Random::new(24);
    for _ in 0..10_000 {
        let (turn, shift) = (random.rotor(), random.translator());
        let factor = random.number() * 4.0;
        if factor.abs() < 1e-2 {
            continue;
        }
        let scaling = Dilator::scaling(factor).expect("not zero");
        let versor = Even::similarity(scaling, turn, shift);
        let parts = (versor * (3.0 * random.number())).similarity_parts(1e-9);
        let (scaling, rotation, translation) = parts.expect("a similarity");
        assert!((scaling.factor().expect("a factor") / factor - 1.0).abs() < 1e-11);
        assert!((translation.vector() - shift.vector()).norm() < 1e-11);
        let x = random.vector();
        assert!((rotation.apply(x) - turn.apply(x)).norm() < 1e-11);
        let p = random.point();
        let one_by_one = turn.apply(p.position() * factor) + shift.vector();
        let image = p.image_under(versor).expect("a point");
        assert!((image.position() - one_by_one).norm() < 1e-11);
    }
    let bend = Even::from(Transversor::by(Vector3::new(1.0, 0.0, 0.0)));
    assert_eq!(bend.similarity_parts(1e-9), None);
    assert_eq!(Even::<f64>::default().similarity_parts(1e-9), None);
}
