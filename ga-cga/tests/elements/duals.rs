//! The dual of each kind of element is called the dual of that.

use ga_cga::Classification::{Direct, Dual};
use ga_cga::{
    Circle, DirectionBivector, DirectionTrivector, DirectionVector, DualSphere, Flat, FlatPoint,
    Line, Multivector, Plane, PointPair, Pseudoscalar, Shape, Sphere, Trivector3, classify,
    classify_dual,
};

use super::oracle::{self, Random, point, vector};

/// Whatever an element is, its dual is the dual of that: every kind of every grade, near and far.
#[test]
fn duals_of_every_kind() {
    let mut random = Random::new(46);
    for _ in 0..2000 {
        let far = 10_f64.powf(6.0 * random.signed().abs());
        let at = point(random.direction() * far);
        let t = vector(random.direction());
        let plane = t.orthogonal_plane();
        let square = (1.0 + far) * (1.0 + far);
        let mut elements: Vec<Multivector> = vec![
            at.into(),
            PointPair::tangent(at, t).into(),
            Circle::tangent(at, plane).into(),
            Sphere::tangent(at).into(),
            FlatPoint::at(at).into(),
            Line::along(at, t).into(),
            Plane::with_normal(at, t).into(),
            Pseudoscalar::new(2.0).into(),
            DualSphere::infinity().into(),
            DirectionVector::along(t).into(),
            DirectionBivector::of(plane).into(),
            DirectionTrivector::of(Trivector3::new(-3.0)).into(),
        ];
        for square in [square, -square] {
            elements.push(PointPair::about(at, square, t).into());
            elements.push(Circle::about(at, square, plane).into());
            elements.push(Sphere::about(at, square).into());
        }
        for element in elements {
            let Direct(shape) = classify(element) else {
                panic!("{element} is direct");
            };
            let Dual(found) = classify_dual(element.dual()) else {
                panic!("{} is a dual", element.dual());
            };
            let [kind, expected] = [found, shape].map(|shape| format!("{shape:?}"));
            let name = |text: &str| text.split(['{', '0', '-']).next().map(str::to_owned);
            assert_eq!(name(&kind), name(&expected), "{element}");
            let miss = oracle::distance(Multivector::from(found), Multivector::from(shape));
            assert!(
                miss <= 1e-15 * oracle::size(Multivector::from(shape)),
                "{element}"
            );
        }
    }
    // The two that are duals of each other without a place: a number and all of space.
    let all = Pseudoscalar::new(2.0);
    assert_eq!(
        classify_dual(all.dual()),
        Dual(Shape::Flat(Flat::Space(all)))
    );
    assert_eq!(classify_dual(all), Direct(Shape::Flat(Flat::Space(all))));
}
