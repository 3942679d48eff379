//! Paths between null elements: tangents anywhere, points with a weight, directions.

use super::law::{BOTH, STRAIGHT, apart, neither, ways};
use crate::random::Random;
use ga_cga::interpolate::{Carry, NoPath, Way};
use ga_cga::*;

/// Tangents are moved and turned, their weight by equal factors, and stay tangents.
#[test]
fn tangents_are_carried() {
    let mut random = Random::new(101);
    for _ in 0..2_000 {
        let (p, q) = (random.point(), random.point());
        let (u, v) = (random.direction() * 3.0, random.vector());
        let [a, b] = [(p, u), (q, v)].map(|(at, along)| PointPair::tangent(at, along));
        assert_eq!(ways(a, b, 1e-9), BOTH);
        let [c, d] =
            [(p, u), (q, v)].map(|(at, along)| Circle::tangent(at, along.orthogonal_plane()));
        assert_eq!(ways(c, d, 1e-9), BOTH);
        assert_eq!(ways(c, -c, 1e-9), neither(NoPath::Opposite));
        let [e, f] = [p, q].map(Sphere::tangent);
        assert_eq!(ways(e, f * 2.0, 1e-9), STRAIGHT);
        assert_eq!(ways(e, -f, 1e-9), neither(NoPath::Reversed));
        let [g, h] = [p, q].map(DualSphere::from);
        assert_eq!(ways(g, h * 5.0, 1e-9), STRAIGHT);
        assert_eq!(ways(g * -1.0, h * -5.0, 1e-9), STRAIGHT);
        assert_eq!(ways(g, -h, 1e-9), neither(NoPath::Reversed));

        // In between: at a point, as long as the geometric mean, along the screw of the motor.
        let path = a.path_to(b, Way::Short).expect("not opposite");
        let middle: PointPair = path.at(0.5);
        let mean = (u.norm() * v.norm()).sqrt();
        assert!((middle.weight() - mean).abs() < 1e-9);
        assert!(middle.radius_squared().expect("a tangent").abs() < 1e-9);
        let point: DualSphere = g.path_to(h, Way::Short).expect("points").at(0.25);
        let expected = p.position() * 0.75 + q.position() * 0.25;
        let center = point.center().expect("a point").position();
        assert!((center - expected).norm() < 1e-12);
    }
}

/// A tangent that is carried without a turn goes straight, and one that stays in its place turns
/// about it: half a right angle is half-way.
#[test]
fn tangents_go_straight_and_turn_in_place() {
    let along = |x, y, z| Vector3::new(x, y, z);
    let here = Point::at(1.0, 2.0, 3.0);
    let there = Point::at(5.0, 2.0, 1.0);
    let east = along(1.0, 0.0, 0.0);
    let path = PointPair::tangent(here, east).path_to(PointPair::tangent(there, east), Way::Short);
    let expected = PointPair::tangent(Point::at(3.0, 2.0, 2.0), east);
    assert!(apart(path.expect("a translation").at(0.5), expected) < 1e-14);
    let north = PointPair::tangent(here, along(0.0, 1.0, 0.0));
    let path = PointPair::tangent(here, east).path_to(north, Way::Short);
    let half = 0.5_f64.sqrt();
    let expected = PointPair::tangent(here, along(half, half, 0.0));
    assert!(apart(path.expect("a quarter turn").at(0.5), expected) < 1e-13);
}

/// Tangents as they are computed, with a radius that is rounding: where spheres touch.
#[test]
fn tangents_of_touching_spheres_are_carried() {
    let mut random = Random::new(102);
    for _ in 0..500 {
        let mut touch = || {
            let (center, along) = (random.point(), random.direction());
            let other = center.position() + along * 3.0;
            let a = DualSphere::about(center, 1.0);
            let b = DualSphere::with_radius(other, 2.0);
            let meet: Circle = (a ^ b).undual();
            (meet, center.position() + along)
        };
        let ((from, start), (to, end)) = (touch(), touch());
        let path = from.path_to(to, Way::Short).expect("tangents");
        assert!(apart(path.at(1.0), to) < 1e-7);
        for (t, place) in [(0.0, start), (1.0, end)] {
            let center = path.at(t).center().expect("a place").position();
            assert!((center - place).norm() < 1e-6);
        }
    }
}

/// Directions in the types that hold them among other things, and the elements at infinity.
#[test]
fn directions_in_wider_types_are_carried() {
    let mut random = Random::new(103);
    for _ in 0..500 {
        let (u, v) = (random.direction(), random.direction() * 4.0);
        let [a, b] = [u, v].map(DirectionVector::along);
        assert_eq!(ways(PointPair::from(a), PointPair::from(b), 1e-12), BOTH);
        assert_eq!(ways(FlatPoint::from(a), FlatPoint::from(b), 1e-12), BOTH);
        assert_eq!(ways(DualLine::from(a), DualLine::from(b), 1e-12), BOTH);
        let [a, b] = [u, v].map(|x| DirectionBivector::of(x.orthogonal_plane()));
        assert_eq!(ways(Circle::from(a), Circle::from(b), 1e-12), BOTH);
        assert_eq!(ways(Line::from(a), Line::from(b), 1e-12), BOTH);
    }
    let infinity = DualSphere::<f64>::infinity();
    assert_eq!(ways(infinity, infinity * 3.0, 1e-14), STRAIGHT);
    assert_eq!(ways(infinity, -infinity, 1e-14), neither(NoPath::Reversed));
    let plane = Plane::from(DirectionTrivector::new(2.0));
    assert_eq!(ways(plane, plane * 3.0, 1e-14), STRAIGHT);
    let sphere = Sphere::from(DirectionTrivector::new(2.0));
    assert_eq!(ways(sphere, sphere * 3.0, 1e-14), STRAIGHT);
}

/// Small scenes are not taken for points: the tolerance goes by the elements themselves.
#[test]
fn small_circles_keep_their_radius() {
    let ring = |x: f64, r: f64| {
        let center = DualSphere::about(Point::at(x, 0.0, 0.0), -r * r);
        center.circle_in(Bivector3::new(0.0, 0.0, 1.0))
    };
    let path = ring(0.0, 1e-9).path_to(ring(3e-9, 2e-9), Way::Short);
    let end: Circle = path.expect("circles").at(1.0);
    let square = end.radius_squared().expect("a circle");
    assert!((square / 4e-18 - 1.0).abs() < 1e-9, "{square}");
}

#[test]
fn null_elements_go_to_their_like_only() {
    let here = Point::at(1.0, 2.0, 3.0);
    let tangent = PointPair::tangent(here, Vector3::new(1.0, 0.0, 0.0));
    let direction = PointPair::from(DirectionVector::along(Vector3::new(0.0, 1.0, 0.0)));
    let pair = PointPair::about(here, 1.0, Vector3::new(0.0, 0.0, 1.0));
    let kinds = [tangent, direction, pair];
    for (i, from) in kinds.into_iter().enumerate() {
        for (j, to) in kinds.into_iter().enumerate() {
            if i != j {
                assert_eq!(
                    ways(from, to, 1e-9),
                    neither(NoPath::DifferentKinds),
                    "{i} {j}"
                );
            }
        }
    }
}
