//! Distances, nearest points and angles against plain vector geometry.

use std::f64::consts::{FRAC_PI_2, PI};

use ga_cga::incidence::{angle, distance, nearest, nearest_points};
use ga_cga::{
    Circle, DirectionVector, DualPlane, DualSphere, Line, Multivector, Plane, Point, PointPair,
    Shape, Sphere, classify,
};

use super::oracle::{Random, figures, near, place, point, rounding, vector};

fn shape(figure: Multivector) -> Shape<f64> {
    classify(figure).shape().expect("an element")
}

/// No sample of one is nearer to the other than the nearest points, and these lie on both.
#[test]
fn nearest_points_are_nearest() {
    let mut random = Random::new(67);
    for _ in 0..40 {
        let (ones, twos) = (figures(&mut random), figures(&mut random));
        for (one, one_at) in &ones {
            for (two, two_at) in &twos {
                let (one, two) = (shape(*one), shape(*two));
                let (p, q) = nearest_points(one, two).expect("real figures");
                let apart = distance(one, two).expect("real figures");
                assert!((p.distance(q) - apart).abs() < 1e-12);
                let back = distance(two, one).expect("real figures");
                assert!(
                    (apart - back).abs() < 1e-11,
                    "{one:?} {two:?}: {apart} and {back}"
                );
                assert!(distance(one, p).is_some_and(|d| d < 1e-12), "{one:?}");
                assert!(distance(two, q).is_some_and(|d| d < 1e-12), "{two:?}");
                for _ in 0..60 {
                    let [x, y] = [(); 2].map(|()| 0.5 + 0.5 * random.signed());
                    let (p, q) = (one_at(x, y), two_at(y, x));
                    assert!((p - q).norm() >= apart - 1e-11);
                    let on_two = nearest(two, point(p)).expect("real figures");
                    let reached = on_two.distance(point(p));
                    assert!((p - q).norm() >= reached - 1e-11 && reached >= apart - 1e-11);
                }
            }
        }
    }
}

/// The closed forms of the textbooks.
#[test]
fn distances_of_the_textbooks() {
    let mut random = Random::new(68);
    for _ in 0..3000 {
        let at = place(&mut random);
        let [a, b] = [(); 2].map(|()| at + random.position(5.0));
        let (t, n) = (random.direction(), random.direction());
        let (r, s) = (random.signed().abs() + 0.1, random.signed().abs() + 0.1);
        let bound = 1e2 * rounding(at);
        let is = |found: Option<f64>, expected: f64, bound: f64, what: &str| {
            let found = found.expect("real figures");
            assert!(
                (found - expected).abs() <= bound * (1.0 + expected),
                "{what}: {found} {expected}"
            );
        };
        is(
            distance(point(a), point(b)),
            (a - b).norm(),
            1e-15,
            "points (2.46)",
        );
        let line = Line::along(point(a), vector(t));
        is(
            distance(line, point(b)),
            (b - a).cross(&t).norm(),
            bound,
            "point and line",
        );
        let plane = Plane::with_normal(point(a), vector(n));
        is(
            distance(point(b), plane),
            n.dot(&(b - a)).abs(),
            bound,
            "point and plane",
        );
        let across = t.cross(&n);
        if across.norm() > 0.1 {
            let other = Line::along(point(b), vector(n));
            let expected = across.normalize().dot(&(b - a)).abs();
            is(distance(line, other), expected, 100.0 * bound, "skew lines");
        }
        let parallel = Line::along(point(b), vector(t * -3.0));
        is(
            distance(line, parallel),
            (b - a).cross(&t).norm(),
            bound,
            "parallel lines",
        );
        let beside = Plane::with_normal(point(b), vector(n * -2.0));
        is(
            distance(plane, beside),
            n.dot(&(b - a)).abs(),
            bound,
            "parallel planes",
        );
        // Radii far away are known to the root of the rounding of their squares.
        let rough = 1e-13 * (1.0 + at.norm_squared()) / r.min(s);
        let [one, two] = [(a, r), (b, s)].map(|(c, r)| DualSphere::with_radius(vector(c), r));
        let apart = ((a - b).norm() - r - s)
            .max(r - s - (a - b).norm())
            .max(s - r - (a - b).norm());
        if rough < 0.01 {
            is(distance(one, two), apart.max(0.0), rough, "spheres");
            let expected = ((b - a).cross(&t).norm() - s).max(0.0);
            is(distance(line, two), expected, rough, "line and sphere");
            let expected = (n.dot(&(b - a)).abs() - s).max(0.0);
            is(distance(two, plane), expected, rough, "plane and sphere");
            is(
                distance(two, point(a)),
                ((a - b).norm() - s).abs(),
                rough,
                "point and sphere",
            );
        }
    }
}

/// Angles of directions, normals and radii; none where nothing crosses.
#[test]
fn angles_of_the_textbooks() {
    let mut random = Random::new(69);
    for _ in 0..3000 {
        let at = random.position(10.0);
        let (t, u) = (random.direction(), random.direction());
        let [a, b] = [(); 2].map(|()| point(at + random.position(1.0)));
        let expected = t.cross(&u).norm().atan2(t.dot(&u));
        let folded = expected.min(PI - expected);
        let is = |found: Option<f64>, expected: f64, what: &str| {
            let found = found.unwrap_or(f64::NAN);
            assert!(
                (found - expected).abs() < 1e-7,
                "{what}: {found} is not {expected}"
            );
            let clear = expected > 1e-2 && expected < PI - 1e-2;
            assert!(
                !clear || (found - expected).abs() < 1e-11,
                "{what}: {found} {expected}"
            );
        };
        let (one, two) = (Line::along(a, vector(t)), Line::along(b, vector(u * 3.0)));
        is(angle(one, two), expected, "lines");
        is(angle(two.dual(), one), expected, "lines");
        let (plane, other) = (
            Plane::with_normal(a, vector(t)),
            Plane::with_normal(b, vector(u)),
        );
        is(angle(plane, other), expected, "planes");
        is(angle(plane.dual(), other.dual()), expected, "planes");
        is(angle(plane, two), FRAC_PI_2 - folded, "plane and line");
        is(angle(two, plane), FRAC_PI_2 - folded, "line and plane");
        is(
            angle(DirectionVector::along(vector(t)), two),
            expected,
            "direction and line",
        );
        is(angle(vector(t), vector(u)), expected, "vectors");
        is(
            angle(vector(t), other),
            FRAC_PI_2 - folded,
            "vector and plane",
        );
        let circle = Circle::with_normal(b, 1.0, vector(u)).expect("a normal");
        is(
            angle(vector(t), circle),
            FRAC_PI_2 - folded,
            "vector and circle",
        );
        is(
            angle(PointPair::tangent(a, vector(t)), two),
            expected,
            "tangent and line",
        );

        // Spheres cross at the angle of their radii to a common point.
        let (c, d) = (at + t * 1.5, at + u * 2.0);
        let [one, two] = [(c, 1.5), (d, 2.0)].map(|(c, r)| DualSphere::with_radius(vector(c), r));
        is(angle(one, two), expected, "spheres");
        let normal = DualPlane::at_distance(vector(u), u.dot(&at));
        is(angle(one, normal), expected, "sphere and plane");
        let through = Line::along(point(at), vector(u));
        is(angle(one, through), FRAC_PI_2 - folded, "sphere and line");
        let apart = DualSphere::with_radius(vector(at - t * 3.0), 1.0);
        assert_eq!(angle(one, apart), None);
        assert_eq!(angle(point(at), one), None);
        assert_eq!(angle(vector(t), one), None);
        assert_eq!(angle(DualSphere::about(point(at), -1.0), normal), None);
    }
    let sphere = |x: f64, r: f64| Sphere::about(Point::at(x, 0.0, 0.0), r * r);
    // Touching spheres: from outside their radii oppose each other.
    near(
        angle(sphere(0.0, 1.0), sphere(1.0, 2.0)).expect("touching"),
        0.0,
        1e-7,
        "inside",
    );
    near(
        angle(sphere(0.0, 1.0), sphere(3.0, 2.0)).expect("touching"),
        PI,
        1e-7,
        "outside",
    );
}
