//! One versor on slices of elements: what it does one by one, whatever their number, and nothing
//! where the lengths differ.
#![cfg(feature = "plane-based")]

use ga_core::ops::{Element, Outermorphism, Versor};
use ga_core::{LengthMismatch, Rational, Unit};
use ga_spaces::plane_based3::{Line, Motor, Plane, Point, Rotor, Translator, WeightedPoint};

/// Fewer and more elements than the matrix needs to be worthwhile.
const LENGTHS: std::ops::RangeInclusive<usize> = 0..=24;

/// Different fractions, none of them zero.
fn elements<X: Element<Number = Rational>>(len: usize) -> Vec<X> {
    let mut numerator = 0;
    let mut next = || {
        numerator += 1;
        Rational::from_integer(numerator % 17 - 20) / Rational::from_integer(numerator % 5 + 1)
    };
    (0..len).map(|_| X::from_fn(|_| next())).collect()
}

/// A motor by fractions, a versor, though not of norm 1.
fn motor() -> Motor<Rational> {
    let [w, x, y, z, a, b, c] = [3, -1, 2, 5, 7, -4, 2].map(Rational::from_integer);
    Translator::new(a, b, c) * Rotor::new(w, x, y, z)
}

/// The same of norm 1: 2 + 3 + 6 over 7 and a zero are the sides of a rotation by fractions.
fn unit_motor() -> Unit<Motor<Rational>> {
    let seventh = |n: i128| Rational::from_integer(n) / Rational::from_integer(7);
    let [a, b, c] = [7, -4, 2].map(Rational::from_integer);
    let rotor = Rotor::new(seventh(2), seventh(3), seventh(-6), Rational::ZERO);
    Unit::promised(Translator::new(a, b, c) * rotor)
}

/// How a slice is moved by a versor, or by the one of norm 1, into another.
type Way<V, X> = fn(V, Unit<V>, &[X], &mut [X]);

/// Asserts that all ways of moving slices move each element as it is moved alone.
fn assert_moved_alike<V, X>(versor: V, unit: Unit<V>)
where
    V: Versor<Number = Rational> + Outermorphism<X, Image = X>,
    X: Element<Number = Rational> + std::fmt::Debug,
{
    for len in LENGTHS {
        let objects = elements::<X>(len);
        let expected: Vec<X> = objects.iter().map(|x| versor.apply_divided(*x)).collect();
        let expected_of_unit: Vec<X> = objects.iter().map(|x| unit.apply(*x)).collect();
        let ways: [(&str, Way<V, X>, &[X]); 6] = [
            (
                "versor",
                |versor, _, objects, images| {
                    let w = versor.over_norm();
                    let done = ga_core::linear_map::apply_slice(versor, w, objects, images);
                    assert_eq!(done, Ok(()));
                },
                &expected,
            ),
            (
                "unit",
                |_, unit, objects, images| assert_eq!(unit.apply_slice(objects, images), Ok(())),
                &expected_of_unit,
            ),
            (
                "matrix",
                |_, unit, objects, images| {
                    let map = unit.linear_map::<X>();
                    assert_eq!(map.apply_slice(objects, images), Ok(()));
                },
                &expected_of_unit,
            ),
            (
                "versor in place",
                |versor, _, objects, images| {
                    images.copy_from_slice(objects);
                    let w = versor.over_norm();
                    ga_core::linear_map::apply_slice_in_place(versor, w, images);
                },
                &expected,
            ),
            (
                "unit in place",
                |_, unit, objects, images| {
                    images.copy_from_slice(objects);
                    unit.apply_slice_in_place(images);
                },
                &expected_of_unit,
            ),
            (
                "matrix in place",
                |_, unit, objects, images| {
                    images.copy_from_slice(objects);
                    unit.linear_map::<X>().apply_slice_in_place(images);
                },
                &expected_of_unit,
            ),
        ];
        for (way, moved, expected) in ways {
            let mut images = vec![X::from_fn(|_| Rational::ONE); len];
            moved(versor, unit, &objects, &mut images);
            assert_eq!(images, expected, "{way} of {len}");
        }
    }
}

#[test]
fn every_element_of_a_slice_is_moved_as_it_is_alone() {
    assert_moved_alike::<_, Point<Rational>>(motor(), unit_motor());
    assert_moved_alike::<_, WeightedPoint<Rational>>(motor(), unit_motor());
    assert_moved_alike::<_, Line<Rational>>(motor(), unit_motor());
    assert_moved_alike::<_, Plane<Rational>>(motor(), unit_motor());
}

#[test]
fn the_lengths_lie_on_both_sides_of_where_the_matrix_is_worthwhile() {
    let least = <Motor<Rational> as Outermorphism<Point<Rational>>>::WORTHWHILE;
    let least = least.expect("a matrix has half of the multiplications");
    assert!(
        *LENGTHS.start() < least && least < *LENGTHS.end(),
        "{least}"
    );
}

#[test]
fn methods_of_the_versor_divide_by_its_norm_once() {
    let points = elements::<Point<Rational>>(24);
    let mut images = points.clone();
    assert_eq!(motor().apply_slice(&points, &mut images), Ok(()));
    let expected: Vec<_> = points.iter().map(|x| motor().apply(*x)).collect();
    assert_eq!(images, expected);
    let mut images = points.clone();
    motor().apply_slice_in_place(&mut images);
    assert_eq!(images, expected);
}

/// A quarter of a turn about the third axis and two units along the first.
#[test]
fn a_known_motion_takes_points_to_where_they_belong() {
    let (half, root) = (0.5, std::f64::consts::FRAC_1_SQRT_2);
    let turn = Rotor::new(root, 0.0, 0.0, -root);
    let motor = Translator::new(-half * 2.0, 0.0, 0.0) * turn;
    let points: Vec<Point> = (0..30).map(|n| Point::at(f64::from(n), 1.0, 3.0)).collect();
    let mut images = points.clone();
    assert_eq!(motor.apply_slice(&points, &mut images), Ok(()));
    for (n, image) in (0..30).zip(images) {
        let expected = Point::at(1.0, f64::from(n), 3.0).to_array();
        for (is, should) in image.to_array().iter().zip(expected) {
            assert!((is - should).abs() < 1e-13, "{n}: {image:?}");
        }
    }
}

#[test]
fn slices_of_different_lengths_are_refused_and_nothing_is_written() {
    for (left, right) in [(0, 1), (1, 0), (3, 2), (2, 3), (24, 23), (23, 24)] {
        let points = elements::<Point<Rational>>(left);
        let before = elements::<Point<Rational>>(right + 1);
        let mut images = before.clone();
        let mismatch = Err(LengthMismatch { left, right });
        let out = &mut images[..right];
        assert_eq!(motor().apply_slice(&points, out), mismatch);
        assert_eq!(unit_motor().apply_slice(&points, out), mismatch);
        let map = motor().linear_map::<Point<Rational>>();
        assert_eq!(map.apply_slice(&points, out), mismatch);
        assert_eq!(images, before);
    }
    let mismatch = LengthMismatch { left: 3, right: 2 };
    assert_eq!(
        mismatch.to_string(),
        "3 elements do not go with 2 one by one; give as many on both sides"
    );
}
