//! §2.4.3.2: rounds and flats as outer products of points, (2.47) to (2.51).

use ga_cga::{Circle, Line, Plane, Point, PointPair, Pseudoscalar, Sphere};
use ga_core::Rational;

use super::figures::{Circular, Direction, exactly, infinity, position, ratio, wide};
use super::samples::each;

/// A point beside a given one.
fn beside(p: Point<Rational>, by: Direction) -> Point<Rational> {
    Point::from(p.position() + by)
}

/// κ = p_a∧p_b holds its two points and no other.
#[test]
fn equation_2_47_two_points_span_a_point_pair() {
    each(|samples| {
        let [a, b, c, ..] = Circular::random(samples).points();
        let pair: PointPair<Rational> = a ^ b;
        assert_eq!(a ^ pair, Circle::default());
        assert_eq!(b ^ pair, Circle::default());
        assert_ne!(c ^ pair, Circle::default());
        let middle = (a.position() + b.position()) * ratio(1, 2);
        assert_ne!(Point::from(middle) ^ pair, Circle::default());
    });
}

/// K = p_a∧p_b∧p_c holds every point of the circle through the three, and no point beside it.
#[test]
fn equation_2_48_three_points_span_a_circle() {
    each(|samples| {
        let figure = Circular::random(samples);
        let [a, b, c, d, e] = figure.points();
        let circle: Circle<Rational> = a ^ b ^ c;
        for p in [a, b, c, d, e] {
            assert_eq!(p ^ circle, Sphere::default());
            for by in figure.frame {
                assert_ne!(beside(p, by * ratio(1, 7)) ^ circle, Sphere::default());
            }
        }
        assert_ne!(Point::from(figure.center) ^ circle, Sphere::default());
    });
}

/// Σ = p_a∧p_b∧p_c∧p_d holds every point of the sphere through the four, and its centre not.
#[test]
fn equation_2_49_four_points_span_a_sphere() {
    each(|samples| {
        let figure = Circular::random(samples);
        let [a, b, c, d, e, f] = figure.points_of_sphere();
        let sphere: Sphere<Rational> = a ^ b ^ c ^ d;
        for p in [a, b, c, d, e, f] {
            assert_eq!(p ^ sphere, Pseudoscalar::default());
        }
        assert_ne!(Point::from(figure.center) ^ sphere, Pseudoscalar::default());
        let outside = beside(e, figure.frame[0] * ratio(1, 7));
        assert_ne!(outside ^ sphere, Pseudoscalar::default());
        // With n_∞ it spans the pseudoscalar, so it does not pass through infinity.
        assert_ne!(sphere ^ infinity(), Pseudoscalar::default());
    });
}

/// Λ = p_a∧p_b∧n_∞, the carrier of a point pair, holds the points of the line through both.
#[test]
fn equation_2_50_a_point_pair_and_infinity_span_a_line() {
    each(|samples| {
        let figure = Circular::random(samples);
        let [a, b, c, ..] = figure.points();
        let circle: Circle<Rational> = a ^ b ^ infinity();
        let line: Line<Rational> = exactly(circle);
        for step in [-3, 0, 1, 2, 5] {
            let along = (b.position() - a.position()) * ratio(step, 2);
            assert_eq!(wide(beside(a, along) ^ line), wide(Sphere::default()));
        }
        assert_ne!(wide(c ^ line), wide(Sphere::default()));
        assert_eq!(wide(infinity() ^ line), wide(Sphere::default()));
    });
}

/// Π = p_a∧p_b∧p_c∧n_∞, the carrier of a circle, holds the points of its plane.
#[test]
fn equation_2_51_a_circle_and_infinity_span_a_plane() {
    each(|samples| {
        let figure = Circular::random(samples);
        let [a, b, c, ..] = figure.points();
        let sphere: Sphere<Rational> = a ^ b ^ c ^ infinity();
        let plane: Plane<Rational> = exactly(sphere);
        let [u, v, n] = figure.frame;
        let foot = position(samples);
        let inside = figure.center + u * foot.e1 + v * foot.e2;
        assert_eq!(Point::from(inside) ^ plane, Pseudoscalar::default());
        assert_ne!(
            Point::from(inside + n * foot.e3) ^ plane,
            Pseudoscalar::default()
        );
        // A single point and infinity are a flat point: it lies in that and in nothing else.
        let flat = a ^ infinity();
        assert_eq!(wide(a ^ flat), wide(Circle::default()));
        assert_ne!(wide(b ^ flat), wide(Circle::default()));
    });
}
