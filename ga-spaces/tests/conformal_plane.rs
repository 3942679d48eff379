//! Conformal algebra of the plane against complex numbers and exact plane geometry.
#![cfg(feature = "conformal-plane")]

use ga_core::Rational;
use ga_spaces::conformal2::{
    Circle, Conformal, Dilator, DualCircle, DualLine, Line, Motor, Point, PointPair, Rotor,
    Translator, Vector2,
};
use nalgebra::Complex;
use proptest::prelude::*;

fn exact() -> impl Strategy<Value = Rational> {
    (-9_i128..=9, 1_i128..=4).prop_map(|(n, d)| Rational::new(n, d))
}

fn exact_point() -> impl Strategy<Value = Point<Rational>> {
    (exact(), exact()).prop_map(|(x, y)| Point::at(x, y))
}

fn complex() -> impl Strategy<Value = Complex<f64>> {
    (-3.0..3.0, -3.0..3.0).prop_map(|(re, im)| Complex::new(re, im))
}

fn vector(z: Complex<f64>) -> Vector2 {
    Vector2::new(z.re, z.im)
}

fn squared_distance(a: Point<Rational>, b: Point<Rational>) -> Rational {
    let (dx, dy) = (a.e1 - b.e1, a.e2 - b.e2);
    dx * dx + dy * dy
}

proptest! {
    /// Points are null, and their inner product is −½ of the squared distance, exactly.
    #[test]
    fn points_measure_distances(a in exact_point(), b in exact_point()) {
        prop_assert_eq!(a.norm_squared(), Rational::from_integer(0));
        prop_assert_eq!(a.scalar_product(b) * Rational::from_integer(-2), squared_distance(a, b));
    }

    /// The circle through three points has them at one distance from its centre; three points of
    /// a line have none.
    #[test]
    fn three_points_span_a_circle(a in exact_point(), b in exact_point(), c in exact_point()) {
        let circle: Circle<Rational> = a ^ b ^ c;
        let dual: DualCircle<Rational> = circle.dual();
        let turn = (b.e1 - a.e1) * (c.e2 - a.e2) - (b.e2 - a.e2) * (c.e1 - a.e1);
        if turn == Rational::from_integer(0) {
            prop_assert_eq!(dual.center(), None);
            prop_assert_eq!(dual.radius_squared(), None);
        } else {
            let center = dual.center().expect("a circle");
            let radius_squared = dual.radius_squared().expect("a circle");
            for point in [a, b, c] {
                prop_assert_eq!(squared_distance(center, point), radius_squared);
            }
        }
    }

    /// Inversion in a circle: c + r² (x − c)/(x − c)², exactly.
    #[test]
    fn circles_invert(center in exact_point(), x in exact_point(), square in exact()) {
        let zero = Rational::from_integer(0);
        prop_assume!(square != zero);
        let circle = DualCircle::about(center, square);
        let image: DualCircle<Rational> = circle.apply(x);
        let distance = squared_distance(center, x);
        if distance == zero {
            prop_assert_eq!(image.center(), None);
        } else {
            let factor = square / distance;
            let expected = Point::at(
                center.e1 + (x.e1 - center.e1) * factor,
                center.e2 + (x.e2 - center.e2) * factor,
            );
            prop_assert_eq!(image.center(), Some(expected));
        }
    }

    /// A scaling and turning, a translation, an inversion with a reflection and a translation are
    /// (α/(z + β) + γ), the general transformation of Möbius that moves infinity.
    #[test]
    fn even_versors_are_moebius_transformations(
        alpha in complex(), beta in complex(), gamma in complex(), z in complex(),
    ) {
        prop_assume!(alpha.norm() > 1e-2 && (z + beta).norm() > 1e-2);
        let inversion = DualCircle::about(Point::at(0.0, 0.0), 1.0);
        let mirror = DualLine::new(0.0, 1.0, 0.0);
        // 1/z is the inversion and then the reflection in the real axis.
        let reciprocal: Conformal = mirror * inversion;
        let scale = Dilator::by_factor(alpha.norm()).expect("positive");
        let turn = Rotor::by_angle(alpha.arg());
        let all = Translator::by(vector(gamma)) * turn * scale * reciprocal * Translator::by(vector(beta));
        let image: DualCircle = all.apply(Point::from(vector(z)));
        let image = image.center().expect("a finite image").position();
        let expected = alpha / (z + beta) + gamma;
        prop_assert!((image - vector(expected)).norm() < 1e-10 * (1.0 + expected.norm()));
    }

    /// Rigid motions are w z + v.
    #[test]
    fn motors_turn_and_shift(angle in -6.0..6.0_f64, shift in complex(), z in complex()) {
        let motor: Motor = Translator::by(vector(shift)) * Rotor::by_angle(angle);
        let image: Point = motor.apply(Point::from(vector(z)));
        let expected = Complex::from_polar(1.0, angle) * z + shift;
        prop_assert!((image.position() - vector(expected)).norm() < 1e-13 * (1.0 + expected.norm()));
    }

    /// A pair gives its points back, in order.
    #[test]
    fn pairs_split_in_order(a in complex(), b in complex()) {
        prop_assume!((a - b).norm() > 1e-2);
        let pair: PointPair = Point::from(vector(a)) ^ Point::from(vector(b));
        let [first, second] = pair.split().expect("two points");
        prop_assert!((first.position() - vector(a)).norm() < 1e-10);
        prop_assert!((second.position() - vector(b)).norm() < 1e-10);
    }

    /// Two circles meet where both equations hold, or do not meet.
    #[test]
    fn circles_meet(a in complex(), b in complex(), r in 0.1..3.0_f64, s in 0.1..3.0_f64) {
        let circle = |c: Complex<f64>, r: f64| DualCircle::about(Point::from(vector(c)), r * r);
        let distance = (a - b).norm();
        prop_assume!((distance - (r + s)).abs() > 1e-2 && (distance - (r - s).abs()).abs() > 1e-2);
        let met: PointPair = (circle(a, r) ^ circle(b, s)).dual();
        let meets = (r - s).abs() < distance && distance < r + s;
        prop_assert_eq!(met.split().is_some(), meets);
        for point in met.split().into_iter().flatten() {
            prop_assert!(((point.position() - vector(a)).norm() - r).abs() < 1e-9);
            prop_assert!(((point.position() - vector(b)).norm() - s).abs() < 1e-9);
        }
    }
}

/// A line is the circle through infinity.
#[test]
fn lines_are_circles_through_infinity() {
    let (a, b) = (Point::at(0.0, 1.0), Point::at(2.0, 1.0));
    let circle: Circle = a ^ b ^ DualCircle::infinity();
    let line = Line::try_from(circle).expect("a line");
    let dual: DualLine = line.dual();
    let unit = dual.normalized().expect("a line");
    assert!((unit.e2.abs() - 1.0).abs() < 1e-15 && unit.e1 == 0.0);
    assert!((unit.ni * unit.e2 - 1.0).abs() < 1e-15);
    let image: Point = dual.apply(Point::at(5.0, 0.0));
    assert!((image.position() - Vector2::new(5.0, 2.0)).norm() < 1e-14);
}

/// Nothing where there is nothing: imaginary pairs, factors that are none, no number.
#[test]
fn degenerate_elements_have_no_parts() {
    let imaginary: PointPair = (DualCircle::about(Point::at(0.0, 0.0), 1.0)
        ^ DualCircle::about(Point::at(9.0, 0.0), 1.0))
    .dual();
    assert_eq!(imaginary.split(), None);
    assert_eq!(PointPair::<f64>::default().split(), None);
    let a = Point::at(1.0, 2.0);
    assert_eq!((a ^ a).split(), None);
    assert_eq!((a ^ DualCircle::infinity()).split(), None);
    assert_eq!((imaginary * f64::NAN).split(), None);
    for factor in [0.0, -2.0, f64::NAN, f64::INFINITY] {
        assert_eq!(Dilator::by_factor(factor), None, "{factor}");
    }
    assert_eq!(DualCircle::<f64>::infinity().center(), None);
    assert_eq!(DualCircle::<f64>::infinity().radius_squared(), None);
}
