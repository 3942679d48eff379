//! The exponential of a 2-blade by the sign of its square (2.62), its logarithm (2.68–2.70), and the
//! inner product of (2.71).

use crate::random::{Random, size};
use ga_cga::{
    Circle, DirectionVector, DualLine, DualSphere, FlatPoint, MinkowskiPlane, Motor, Multivector,
    Point, PointPair, Rotor, Scalar, TangentVector, Vector3,
};

/// 2-blades of size one with negative, positive and no square: dual circles, point pairs, tangents.
fn blades(random: &mut Random) -> [(PointPair, f64); 3] {
    let mut p = || random.point();
    let circle: PointPair = (p() ^ p() ^ p()).dual();
    let pair: PointPair = p() ^ p();
    let at_origin = TangentVector::from(random.vector().to_array());
    let tangent: PointPair = random.motor().apply(at_origin);
    [(circle, -1.0), (pair, 1.0), (tangent, 0.0)].map(|(blade, sign): (PointPair, f64)| {
        let norm = if sign == 0.0 {
            size(blade)
        } else {
            blade.scalar_product(blade).abs().sqrt()
        };
        (blade / norm, sign)
    })
}

/// (2.62): cosh and sinh, cos and sin, or the first two terms.
#[test]
fn the_sign_of_the_square_decides() {
    let mut random = Random::new(91);
    for _ in 0..2_000 {
        let theta = 3.0 * random.number();
        let half = theta / 2.0;
        for (blade, sign) in blades(&mut random) {
            if size(blade) > 1e2 {
                continue;
            }
            let (one, factor) = match sign {
                1.0 => (half.cosh(), half.sinh()),
                -1.0 => (half.cos(), half.sin()),
                _ => (1.0, half),
            };
            let blade_part = Multivector::from(blade) * factor;
            let expected = Multivector::from(Rotor::identity()) * one - blade_part;
            let rotor = (blade * -half).exp();
            // Rounding of the coefficients of a blade enters its square twice.
            let tolerance = 1e-13 * (1.0 + size(blade) * size(blade)) * size(expected);
            let off = size(Multivector::from(rotor) - expected);
            assert!(off < tolerance, "{sign}: {off} for {blade} by {half}");
            // (2.65): the reverse is the inverse.
            let rotor = Multivector::from(rotor);
            let unit = rotor * rotor.reverse() - Multivector::from(Rotor::identity());
            assert!(size(unit) < 1e-11 * (1.0 + size(rotor) * size(rotor)));
        }
    }
}

/// The list of section 2.4.4, each from its generator.
#[test]
fn each_generator_makes_its_versor() {
    let mut random = Random::new(92);
    for _ in 0..1_000 {
        let (v, p, x) = (random.vector(), random.point(), random.point());
        let c = random.number();
        let [a, b, e] = (v * -0.5).to_array();
        let shift = DirectionVector::new(a, b, e).exp();
        assert!((shift.apply(x).position() - (x.position() + v)).norm() < 1e-14);
        let bend = TangentVector::new(a, b, e).exp();
        assert!((bend.vector() - v).norm() < 1e-15);
        let scaling = (MinkowskiPlane::new(1.0) * (-c / 2.0)).exp();
        let image = x.image_under(scaling).expect("a point");
        assert!((image.position() - x.position() * (-c).exp()).norm() < 1e-13);
        let flat: FlatPoint = (p ^ DualSphere::infinity())
            .narrow(0.0)
            .expect("a flat point");
        let image = x
            .image_under((flat * (-c / 2.0)).exp())
            .expect("a point")
            .position();
        let expected = p.position() + (x.position() - p.position()) * (-c).exp();
        assert!((image - expected).norm() < 1e-12);
    }
}

/// (2.68), (2.69): the logarithm is the generator again, with the sign of the scalar part respected.
#[test]
fn logarithms_are_generators() {
    let mut random = Random::new(93);
    for _ in 0..2_000 {
        let half = 3.0 * random.number();
        for (blade, sign) in blades(&mut random) {
            if size(blade) > 1e2 {
                continue;
            }
            let generator = blade * half;
            let rotor = generator.exp();
            let log = rotor.log().expect("it is an exponential");
            assert!(
                size(log - generator) < 1e-9 * size(blade),
                "{sign}: {log} is not {generator}"
            );
        }
    }
    // With a negative scalar part a translator has no logarithm, its negative has.
    let shift = Motor::from(DirectionVector::new(1.0, 2.0, 3.0).exp());
    assert_eq!((-shift).log(), None);
    assert!(shift.log().is_some());
}

/// (2.70): what is left to a whole turn is the logarithm of −R, and it acts the same.
#[test]
fn the_other_way_is_the_logarithm_of_the_negative() {
    use ga_cga::interpolate::{Continuous, Way};
    let mut random = Random::new(94);
    for _ in 0..2_000 {
        let motor = random.motor();
        let ways = [Way::Short, Way::Long].map(|way| motor.generator(way).expect("it turns"));
        let [short, long]: [DualLine; 2] = ways;
        let x = random.point();
        for generator in [short, long] {
            let moved = Motor::power(generator, 1.0).apply(x);
            assert!(moved.distance(motor.apply(x)) < 1e-11);
        }
        let rotor = random.rotor();
        let ways = [Way::Short, Way::Long].map(|way| rotor.generator(way).expect("it turns"));
        let [short, long] = ways;
        let theta = short.norm();
        let printed = short * (-(std::f64::consts::PI - theta) / theta);
        assert!((printed - long).norm() < 1e-9, "{printed} is not {long}");
    }
}

/// (2.71): the lowest grade of the product, and zero where one side is a scalar.
#[test]
fn the_inner_product_is_the_lowest_grade() {
    let mut random = Random::new(95);
    for _ in 0..1_000 {
        let vector: Vector3 = random.element();
        let pair: PointPair = random.element();
        let circle: Circle = random.element();
        let product = pair * circle;
        let inner = pair | circle;
        assert!(size(product.grade(1) - ga_cga::Odd::from(inner)) < 1e-13);
        let inner = circle | pair;
        assert!(size((circle * pair).grade(1) - ga_cga::Odd::from(inner)) < 1e-13);
        assert_eq!(Scalar::new(3.0) | vector, Scalar::new(0.0));
        assert_eq!(circle | Scalar::new(3.0), Scalar::new(0.0));
        let (a, b) = (random.point(), random.point());
        let Scalar { s } = a | b;
        assert!((s + 0.5 * a.distance(b).powi(2)).abs() < 1e-13);
    }
    assert_eq!(
        Point::at(0.0, 0.0, 0.0) | Scalar::new(1.0),
        Scalar::new(0.0)
    );
}
