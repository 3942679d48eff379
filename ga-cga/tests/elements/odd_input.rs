//! Queries of arbitrary finite elements never answer NaN.

use ga_cga::{
    Circle, DirectionBivector, DirectionTrivector, DirectionVector, DualLine, DualPlane,
    DualSphere, FlatPoint, Line, Plane, Point, PointPair, Sphere, SplitPair, TangentBivector,
    TangentTrivector, TangentVector, Vector3,
};
use ga_core::Element;

use super::oracle::Random;

/// Everything that can be asked, as numbers.
trait Answers {
    fn answers(self) -> Vec<f64>;
}

fn coefficients<X: Element<Number = f64>>(x: X) -> Vec<f64> {
    (0..X::BLADES.len()).map(|i| x.at(i)).collect()
}

fn maybe<X: Element<Number = f64>>(x: Option<X>) -> Vec<f64> {
    x.map(coefficients).unwrap_or_default()
}

fn split_numbers(split: SplitPair<f64>) -> Vec<f64> {
    match split {
        SplitPair::Real { first, second } => [coefficients(first), coefficients(second)].concat(),
        SplitPair::Tangent { point, direction } => {
            [coefficients(point), coefficients(direction)].concat()
        }
        SplitPair::Imaginary {
            center,
            radius_squared,
            direction,
        } => [
            coefficients(center),
            coefficients(direction),
            vec![radius_squared],
        ]
        .concat(),
        SplitPair::WithInfinity(point) => coefficients(point),
        SplitPair::NoPair(_) => Vec::new(),
    }
}

macro_rules! answers {
    ($($Element:ident($x:ident): $($answer:expr),*;)*) => {$(
        impl Answers for $Element {
            fn answers(self) -> Vec<f64> {
                let $x = self;
                [$($answer),*].concat()
            }
        }
    )*};
}

answers! {
    DualSphere(x): maybe(x.center()), x.radius_squared().into_iter().collect(), maybe(x.unit_weight());
    DualPlane(x): x.distance_from_origin().into_iter().collect(), coefficients(x.normal()),
        maybe(x.nearest(Point::at(1.0, 2.0, 3.0))), coefficients(x.attitude()), vec![x.weight()];
    PointPair(x): maybe(x.center()), x.radius_squared().into_iter().collect(), maybe(x.surround()),
        coefficients(x.carrier()), coefficients(x.attitude()), vec![x.weight()], split_numbers(x.split());
    Circle(x): maybe(x.center()), x.radius_squared().into_iter().collect(), maybe(x.surround()),
        coefficients(x.carrier()), coefficients(x.attitude()), vec![x.weight()], coefficients(x.normal());
    Sphere(x): maybe(x.center()), x.radius_squared().into_iter().collect(), maybe(x.surround()),
        coefficients(x.carrier()), coefficients(x.attitude()), vec![x.weight()];
    FlatPoint(x): maybe(x.location()), vec![x.weight()], maybe(x.nearest(Point::at(1e300, 2.0, 3.0)));
    Line(x): coefficients(x.direction()), vec![x.weight()], maybe(x.nearest(Point::at(1.0, 2.0, 3.0)));
    DualLine(x): coefficients(x.direction()), vec![x.weight()], maybe(x.nearest(Point::at(1.0, 2.0, 3.0)));
    Plane(x): coefficients(x.normal()), vec![x.weight()], maybe(x.nearest(Point::at(1.0, 2.0, 3.0)));
    DirectionVector(x): coefficients(x.vector()), vec![x.weight()];
    DirectionBivector(x): coefficients(x.bivector()), vec![x.weight()];
    DirectionTrivector(x): coefficients(x.trivector()), vec![x.weight()];
    TangentVector(x): coefficients(x.vector()), PointPair::from(x).answers();
    TangentBivector(x): coefficients(x.bivector()), Circle::from(x).answers();
    TangentTrivector(x): coefficients(x.trivector()), Sphere::from(x).answers();
    Vector3(x): coefficients(x.orthogonal_plane()), coefficients(x.orthogonal_plane().normal());
}

/// Asks an element of arbitrary finite coefficients everything.
fn ask<X: Answers + Element<Number = f64> + std::fmt::Debug>(random: &mut Random) {
    const ODD: [f64; 12] = [
        0.0,
        1.0,
        -1.0,
        5e-324,
        1e-310,
        1e-200,
        1e-100,
        1e100,
        -1e200,
        f64::MAX,
        f64::MIN,
        0.5,
    ];
    for round in 0..3000 {
        let spread = if round % 2 == 0 { 300.0 } else { 8.0 };
        let x = X::from_fn(|_| {
            let pick = ((random.signed() + 1.0) * 12.0) as usize;
            match ODD.get(pick) {
                Some(odd) if round % 3 == 0 => *odd,
                _ if pick > 20 => 0.0,
                _ => random.signed() * 10_f64.powf(spread * random.signed()),
            }
        });
        let answers = x.answers();
        assert!(answers.iter().all(|x| !x.is_nan()), "{x:?}: {answers:?}");
    }
    let zero = X::from_fn(|_| 0.0).answers();
    assert!(zero.iter().all(|x| !x.is_nan()), "{zero:?}");
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        // No promise about the answers but that there are some.
        let _ = X::from_fn(|i| if i == 0 { bad } else { 1.0 }).answers();
    }
}

/// No query answers NaN or panics, whatever the finite element.
#[test]
fn no_query_answers_nan() {
    let mut random = Random::new(28);
    macro_rules! ask_all {
        ($($Element:ident)*) => {$(ask::<$Element>(&mut random);)*};
    }
    ask_all! {
        DualSphere DualPlane PointPair Circle Sphere FlatPoint Line DualLine Plane DirectionVector
        DirectionBivector DirectionTrivector TangentVector TangentBivector TangentTrivector Vector3
    }
}
