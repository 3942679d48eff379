//! The conformal models of one to five dimensions against coordinates, exactly and by one code.
#![cfg(feature = "conformal")]

use ga_core::ops::{Apply, Reverse};
use ga_core::{Element, Rational};
use ga_spaces::conformal::{Conformal, ConformalSpace};
use proptest::prelude::*;

type Number = Rational;
type Outcome = Result<(), TestCaseError>;

fn exact() -> impl Strategy<Value = Number> {
    (-5_i128..=5, 1_i128..=3).prop_map(|(n, d)| Rational::new(n, d))
}

/// Coordinates, of which as many are used as there are dimensions.
fn five() -> impl Strategy<Value = Vec<Number>> {
    proptest::collection::vec(exact(), 5)
}

fn zero() -> Number {
    Rational::from_integer(0)
}

fn vector<S: ConformalSpace<Number>>(coordinates: &[Number]) -> S::Vector {
    S::Vector::from_fn(|i| coordinates[i])
}

fn coordinates<S: ConformalSpace<Number>>(x: S::Vector) -> Vec<Number> {
    (0..S::DIMENSION).map(|i| x.at(i)).collect()
}

fn point<S: ConformalSpace<Number>>(at: &[Number]) -> S::Point {
    S::point(vector::<S>(at))
}

fn dot(a: &[Number], b: &[Number]) -> Number {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// a + f b, coordinate by coordinate.
fn add(a: &[Number], f: Number, b: &[Number]) -> Vec<Number> {
    a.iter().zip(b).map(|(a, b)| a + f * b).collect()
}

fn inner_products_are_distances<S: ConformalSpace<Number>>(a: &[Number], b: &[Number]) -> Outcome {
    let (p, q) = (point::<S>(a), point::<S>(b));
    let apart = add(a, -Rational::from_integer(1), b);
    prop_assert_eq!(S::squared_distance(p, q), dot(&apart, &apart));
    prop_assert_eq!(S::squared_distance(p, p), zero());
    let found = S::position(p.into()).map(coordinates::<S>);
    prop_assert_eq!(found, Some(a.to_vec()));
    Ok(())
}

fn spheres_measure_and_invert<S: ConformalSpace<Number>>(
    center: &[Number],
    square: Number,
    x: &[Number],
) -> Outcome {
    let sphere = S::dual_sphere(point::<S>(center), square);
    prop_assert_eq!(S::radius_squared(sphere), Some(square));
    prop_assert_eq!(
        S::position(sphere).map(coordinates::<S>),
        Some(center.to_vec())
    );
    let from_center = add(x, -Rational::from_integer(1), center);
    let distance = dot(&from_center, &from_center);
    let expected = (distance != zero()).then(|| add(center, square / distance, &from_center));
    match S::reflect(sphere, point::<S>(x).into()) {
        Some(image) => prop_assert_eq!(S::position(image).map(coordinates::<S>), expected),
        None => prop_assert_eq!(square, zero()),
    }
    Ok(())
}

fn planes_reflect<S: ConformalSpace<Number>>(
    normal: &[Number],
    offset: Number,
    x: &[Number],
) -> Outcome {
    let plane = S::dual_plane(vector::<S>(normal), offset);
    prop_assert_eq!(S::radius_squared(plane), None);
    prop_assert_eq!(S::position(plane).map(coordinates::<S>), None);
    let square = dot(normal, normal);
    let image = S::reflect(plane, point::<S>(x).into()).and_then(S::position);
    let expected = (square != zero()).then(|| {
        let height = (dot(normal, x) - offset) / square;
        add(x, Rational::from_integer(-2) * height, normal)
    });
    prop_assert_eq!(image.map(coordinates::<S>), expected);
    Ok(())
}

fn translators_shift<S: ConformalSpace<Number>>(v: &[Number], x: &[Number]) -> Outcome {
    let translator = S::translator(vector::<S>(v));
    let image: S::Point = translator.apply(point::<S>(x));
    prop_assert!(image == point::<S>(&add(x, Rational::from_integer(1), v)));
    prop_assert!(translator.reverse().apply(image) == point::<S>(x));
    // The same as any versor.
    let versor: S::Versor = translator.into();
    prop_assert!(versor.apply(point::<S>(x).into()) == image.into());
    Ok(())
}

fn rotors_are_two_reflections<S: ConformalSpace<Number>>(
    a: &[Number],
    b: &[Number],
    x: &[Number],
) -> Outcome {
    let Some(rotor) = S::rotor(vector::<S>(a), vector::<S>(b)) else {
        prop_assert!(dot(a, a) == zero() || dot(b, b) == zero());
        return Ok(());
    };
    let reflected =
        |x: &[Number], n: &[Number]| add(x, Rational::from_integer(-2) * dot(n, x) / dot(n, n), n);
    let expected = reflected(&reflected(x, a), b);
    let image = S::position(rotor.apply(point::<S>(x).into()));
    prop_assert_eq!(image.map(coordinates::<S>), Some(expected));
    Ok(())
}

fn dilators_scale<S: ConformalSpace<Number>>(factor: Number, x: &[Number]) -> Outcome {
    let image = S::dilator(factor).map(|dilator| dilator.apply(point::<S>(x).into()));
    let expected = (factor != zero()).then(|| x.iter().map(|x| x * factor).collect::<Vec<_>>());
    prop_assert_eq!(image.and_then(S::position).map(coordinates::<S>), expected);
    Ok(())
}

fn transversors_bend<S: ConformalSpace<Number>>(v: &[Number], x: &[Number]) -> Outcome {
    let image = S::position(S::transversor(vector::<S>(v)).apply(point::<S>(x).into()));
    let one = Rational::from_integer(1);
    let divisor = one + Rational::from_integer(2) * dot(v, x) + dot(v, v) * dot(x, x);
    let expected = (divisor != zero()).then(|| {
        let numerator = add(x, dot(x, x), v);
        numerator.iter().map(|n| n / divisor).collect::<Vec<_>>()
    });
    prop_assert_eq!(image.map(coordinates::<S>), expected);
    Ok(())
}

/// All laws for one dimension, with so many of the coordinates.
fn all_laws<S: ConformalSpace<Number>>(
    a: &[Number],
    b: &[Number],
    x: &[Number],
    square: Number,
) -> Outcome {
    let [a, b, x] = [a, b, x].map(|v| &v[..S::DIMENSION]);
    inner_products_are_distances::<S>(a, x)?;
    spheres_measure_and_invert::<S>(a, square, x)?;
    planes_reflect::<S>(a, square, x)?;
    translators_shift::<S>(a, x)?;
    rotors_are_two_reflections::<S>(a, b, x)?;
    dilators_scale::<S>(square, x)?;
    transversors_bend::<S>(a, x)
}

proptest! {
    #[test]
    fn one_dimension(a in five(), b in five(), x in five(), square in exact()) {
        all_laws::<Conformal<1>>(&a, &b, &x, square)?;
    }

    #[test]
    fn two_dimensions(a in five(), b in five(), x in five(), square in exact()) {
        all_laws::<Conformal<2>>(&a, &b, &x, square)?;
    }

    #[test]
    fn three_dimensions(a in five(), b in five(), x in five(), square in exact()) {
        all_laws::<Conformal<3>>(&a, &b, &x, square)?;
    }

    #[test]
    fn four_dimensions(a in five(), b in five(), x in five(), square in exact()) {
        all_laws::<Conformal<4>>(&a, &b, &x, square)?;
    }

    #[test]
    fn five_dimensions(a in five(), b in five(), x in five(), square in exact()) {
        all_laws::<Conformal<5>>(&a, &b, &x, square)?;
    }
}

/// What is null mirrors nothing, and no position is made of infinity.
fn nulls_are_none<S: ConformalSpace<f64>>() {
    let x = S::point(S::Vector::default());
    assert!(S::reflect(x.into(), x.into()).is_none());
    assert!(S::reflect(S::infinity(), x.into()).is_none());
    assert!(S::position(S::infinity()).is_none());
    assert!(S::radius_squared(S::infinity()).is_none());
    assert!(S::dilator(0.0).is_none() && S::dilator(f64::NAN).is_none());
    assert!(S::rotor(S::Vector::default(), S::Vector::default()).is_none());
    assert!(S::axis(S::DIMENSION + 2) == S::origin() * 0.0);
    assert!(S::axis(usize::MAX) == S::origin() * 0.0);
}

#[test]
fn degenerate_elements_are_none_in_every_dimension() {
    nulls_are_none::<Conformal<1>>();
    nulls_are_none::<Conformal<2>>();
    nulls_are_none::<Conformal<3>>();
    nulls_are_none::<Conformal<4>>();
    nulls_are_none::<Conformal<5>>();
}
