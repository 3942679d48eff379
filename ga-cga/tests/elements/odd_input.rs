//! Arbitrary finite elements get answers that are numbers, in double and single precision.

use ga_cga::incidence::{angle, contains, distance, join, meet, nearest, plunge, project, reject};
use ga_cga::{
    Bivector3, Circle, Classification, Dilator, DirectionBivector, DirectionTrivector,
    DirectionVector, DualLine, DualPlane, DualSphere, Even, FlatPoint, Line, Motor, Multivector,
    Plane, Point, PointPair, Rotor, Shape, Sphere, SplitPair, TangentBivector, TangentTrivector,
    TangentVector, Translator, Transversor, Vector3, classify,
};
use ga_core::{Element, Real, Scalar};

use super::oracle::Random;

/// Everything that can be asked, as numbers.
trait Answers {
    fn answers(self) -> Vec<f64>;
}

/// The numbers that are asked with.
trait Number: Real + Into<f64> {}

impl Number for f32 {}
impl Number for f64 {}

fn coefficients<X: Element<Number: Number>>(x: X) -> Vec<f64> {
    (0..X::BLADES.len()).map(|i| x.at(i).into()).collect()
}

fn number<T: Number>(x: T) -> Vec<f64> {
    vec![x.into()]
}

fn maybe_number<T: Number>(x: Option<T>) -> Vec<f64> {
    x.map(number).unwrap_or_default()
}

fn maybe<X: Element<Number: Number>>(x: Option<X>) -> Vec<f64> {
    x.map(coefficients).unwrap_or_default()
}

fn split_numbers<T: Number>(split: SplitPair<T>) -> Vec<f64> {
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
            number(radius_squared),
        ]
        .concat(),
        SplitPair::WithInfinity(point) => coefficients(point),
        SplitPair::NoPair(_) => Vec::new(),
    }
}

fn rows<T: Number, const N: usize>(matrix: Option<[[T; N]; N]>) -> Vec<f64> {
    let numbers = matrix.into_iter().flatten().flatten();
    numbers.map(Into::into).collect()
}

fn similar<T: Number>(parts: Option<(Dilator<T>, Rotor<T>, Translator<T>)>) -> Vec<f64> {
    let numbers = parts.map(|(scaling, rotation, shift)| {
        let scaling = [coefficients(scaling), maybe_number(scaling.factor())].concat();
        [scaling, coefficients(rotation), coefficients(shift)].concat()
    });
    numbers.unwrap_or_default()
}

fn place<T: Real>() -> Point<T> {
    Point::at(T::ONE, T::from_integer(-2), T::from_integer(3))
}

/// So far that its square is beyond the range of either number.
fn far<T: Real>() -> Point<T> {
    Point::at(T::from_f64(1e30) * T::from_f64(1e5), T::ONE, T::ZERO)
}

macro_rules! answers {
    ($($Element:ident($x:ident): $($answer:expr),*;)*) => {$(
        impl<T: Number> Answers for $Element<T> {
            fn answers(self) -> Vec<f64> {
                let $x = self;
                [$($answer),*].concat()
            }
        }
    )*};
}

answers! {
    DualSphere(x): maybe(x.center()), maybe_number(x.radius_squared()), maybe(x.unit_weight());
    DualPlane(x): maybe_number(x.distance_from_origin()), coefficients(x.normal()),
        maybe(x.nearest(place())), coefficients(x.attitude()), number(x.weight());
    PointPair(x): maybe(x.center()), maybe_number(x.radius_squared()), maybe(x.surround()),
        coefficients(x.carrier()), coefficients(x.attitude()), number(x.weight()), split_numbers(x.split());
    Circle(x): maybe(x.center()), maybe_number(x.radius_squared()), maybe(x.surround()),
        coefficients(x.carrier()), coefficients(x.attitude()), number(x.weight()), coefficients(x.normal());
    Sphere(x): maybe(x.center()), maybe_number(x.radius_squared()), maybe(x.surround()),
        coefficients(x.carrier()), coefficients(x.attitude()), number(x.weight());
    FlatPoint(x): maybe(x.location()), number(x.weight()), maybe(x.nearest(far()));
    Line(x): coefficients(x.direction()), number(x.weight()), maybe(x.nearest(place()));
    DualLine(x): coefficients(x.direction()), number(x.weight()), maybe(x.nearest(place()));
    Plane(x): coefficients(x.normal()), number(x.weight()), maybe(x.nearest(place()));
    DirectionVector(x): coefficients(x.vector()), number(x.weight());
    DirectionBivector(x): coefficients(x.bivector()), number(x.weight());
    DirectionTrivector(x): coefficients(x.trivector()), number(x.weight());
    TangentVector(x): coefficients(x.vector()), PointPair::from(x).answers();
    TangentBivector(x): coefficients(x.bivector()), Circle::from(x).answers();
    TangentTrivector(x): coefficients(x.trivector()), Sphere::from(x).answers();
    Vector3(x): coefficients(x.orthogonal_plane()), coefficients(x.orthogonal_plane().normal());
    Bivector3(x): coefficients(x.normal()), coefficients(x.normal().orthogonal_plane());
    Point(x): coefficients(x.position()), number(x.distance(place()));
    Rotor(x): number(x.angle()), maybe(x.plane()), maybe(x.axis()), rows(x.to_matrix()),
        x.to_quaternion().map(Into::into).to_vec();
    Translator(x): coefficients(x.vector());
    Motor(x): maybe(x.rotation()), maybe(x.translation()), rows(x.to_matrix()),
        maybe(x.renormalized()), x.to_dual_quaternion().as_flattened().iter().map(|c| (*c).into()).collect();
    Dilator(x): maybe_number(x.factor());
    Transversor(x): coefficients(x.vector());
    Even(x): similar(x.similarity_parts(T::from_ratio(1, 1000))),
        rows(x.to_matrix(T::from_ratio(1, 1000)));
}

/// Asks an element of arbitrary finite coefficients everything.
fn ask<X>(random: &mut Random)
where
    X: Answers + Element<Number: Number> + std::fmt::Debug,
{
    let odd = [
        0.0,
        1.0,
        -1.0,
        5e-324,
        1e-310,
        1e-200,
        1e-45,
        1e-40,
        1e-30,
        1e-100,
        1e20,
        1e100,
        -1e200,
        3e38,
        -3e38,
        f64::MAX,
        f64::MIN,
        0.5,
    ];
    for round in 0..3000 {
        let spread = [300.0, 38.0, 8.0][round % 3];
        let x = X::from_fn(|_| {
            let pick = ((random.signed() + 1.0) * 18.0) as usize;
            let value = match odd.get(pick) {
                Some(odd) if round % 2 == 0 => *odd,
                _ if pick > 30 => 0.0,
                _ => random.signed() * 10_f64.powf(spread * random.signed()),
            };
            let value = X::Number::from_f64(value);
            if value.is_finite() {
                value
            } else {
                X::Number::ONE
            }
        });
        let answers = x.answers();
        assert!(answers.iter().all(|x| !x.is_nan()), "{x:?}: {answers:?}");
    }
    let zero = X::from_fn(|_| X::Number::ZERO).answers();
    assert!(zero.iter().all(|x| !x.is_nan()), "{zero:?}");
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let bad = X::Number::from_f64(bad);
        // No promise about the answers but that there are some.
        let _ = X::from_fn(|i| if i == 0 { bad } else { X::Number::ONE }).answers();
    }
}

/// No query answers NaN or panics, whatever the finite element, in double and single precision.
#[test]
fn no_query_answers_nan() {
    let mut random = Random::new(28);
    macro_rules! ask_all {
        ($($Element:ident)*) => {$(
            ask::<$Element<f64>>(&mut random);
            ask::<$Element<f32>>(&mut random);
        )*};
    }
    ask_all! {
        DualSphere DualPlane PointPair Circle Sphere FlatPoint Line DualLine Plane DirectionVector
        DirectionBivector DirectionTrivector TangentVector TangentBivector TangentTrivector Vector3
        Bivector3 Point Rotor Translator Motor Dilator Transversor Even
    }
}

/// A random shape with coefficients of very different sizes.
fn any_shape<T: Number>(random: &mut Random, round: usize) -> Shape<T> {
    let spread = [2.0, 8.0, 100.0][round % 3];
    loop {
        let [a, b, c] = [(); 3].map(|()| {
            DualSphere::<T>::from_fn(|_| {
                let value = random.signed() * 10_f64.powf(spread * random.signed());
                let value = T::from_f64(value);
                if random.signed() < -0.5 || !value.is_finite() {
                    T::ZERO
                } else {
                    value
                }
            })
        });
        let x: Multivector<T> = match round % 5 {
            0 => a.into(),
            1 => (a ^ b).into(),
            2 => (a ^ b ^ c).into(),
            3 => a.undual().into(),
            _ => (a.undual() ^ b).into(),
        };
        if let Some(shape) = classify(x).shape() {
            return shape;
        }
    }
}

fn sane<T: Number>(class: Classification<T>) {
    if let Some(shape) = class.shape() {
        let numbers = coefficients(Multivector::from(shape));
        assert!(numbers.iter().all(|x| !x.is_nan()), "{class:?}");
    }
}

fn relate<T: Number>(random: &mut Random) {
    for round in 0..1000 {
        let (a, b) = (
            any_shape::<T>(random, round),
            any_shape::<T>(random, round / 5),
        );
        sane(meet(a, b));
        sane(join(a, b));
        sane(plunge(a, b));
        project(a, b).into_iter().chain(reject(a, b)).for_each(sane);
        contains(a, b);
        for number in [angle(a, b), distance(a, b)].into_iter().flatten() {
            assert!(number.is_finite(), "{a:?} {b:?}");
        }
        let near = maybe(nearest(a, place()));
        assert!(near.iter().all(|x| !x.is_nan()), "{a:?}");
    }
    let (zero, point) = (PointPair::<T>::default(), place::<T>());
    let broken = point.map(|_| T::from_f64(f64::NAN));
    for (found, expected) in [
        (meet(zero, point), Classification::Zero),
        (join(point, zero), Classification::Zero),
        (plunge(zero, zero), Classification::Zero),
        (meet(broken, point), Classification::NotFinite),
        (join(point, broken), Classification::NotFinite),
    ] {
        assert_eq!(found, expected);
    }
    assert_eq!(project(zero, point), Some(Classification::Zero));
    assert_eq!(distance(zero, point), None);
    assert_eq!(angle(broken, point), None);
    assert_eq!(nearest(broken, point), None);
    assert!(!contains(zero, point) && !contains(point, broken));
}

/// Whatever the two elements: an answer, without panic and without NaN.
#[test]
fn any_two_elements_have_answers() {
    let mut random = Random::new(72);
    relate::<f64>(&mut random);
    relate::<f32>(&mut random);
}
