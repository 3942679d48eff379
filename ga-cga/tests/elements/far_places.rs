//! Queries far from the origin and at weights near the ends of the range: the promised accuracy.

use ga_cga::{Circle, Line, Plane, Point, PointPair, Sphere, Vector3};

use super::oracle::{self, Random, plain, point, vector};

/// The bounds of the module documentation, 10⁶ away from the origin and nearer.
#[test]
fn far_places_keep_the_promised_accuracy() {
    let mut random = Random::new(26);
    let epsilon = f64::EPSILON;
    for _ in 0..5000 {
        let far = 10_f64.powf(6.0 * random.signed().abs());
        let center = random.direction() * far;
        let (radius_squared, t) = (4.0 * random.signed(), random.direction());
        let pair = PointPair::about(point(center), radius_squared, vector(t));
        let circle = Circle::about(point(center), radius_squared, vector(t).orthogonal_plane());
        let sphere = Sphere::about(point(center), radius_squared);
        let place = 16.0 * epsilon * (far + 2.0);
        let square = 16.0 * epsilon * (far * far + 4.0);
        for (found, found_square) in [
            (pair.center(), pair.radius_squared()),
            (circle.center(), circle.radius_squared()),
            (sphere.center(), sphere.radius_squared()),
            (sphere.dual().center(), sphere.dual().radius_squared()),
        ] {
            let miss = (plain(found.expect("round").position()) - center).norm();
            assert!(miss <= place, "centre {miss:e} off at {far:e}");
            let miss = (found_square.expect("round") - radius_squared).abs();
            assert!(miss <= square, "squared radius {miss:e} off at {far:e}");
        }
        let line = Line::along(point(center), vector(t));
        let x = center + random.position(10.0);
        let foot = center + t * t.dot(&(x - center));
        let miss = (plain(line.nearest(point(x)).expect("a line").position()) - foot).norm();
        assert!(miss <= 2.0 * place, "foot {miss:e} off at {far:e}");
        let plane = Plane::with_normal(point(center), vector(t));
        let foot = x - t * t.dot(&(x - center));
        let miss = (plain(plane.nearest(point(x)).expect("a plane").position()) - foot).norm();
        assert!(miss <= 2.0 * place, "foot {miss:e} off at {far:e}");
    }
}

/// The three points of a triangle 10⁶ away determine its circle as well as near the origin.
#[test]
fn circles_through_far_points() {
    let mut random = Random::new(27);
    for _ in 0..1000 {
        let away = random.direction() * 1e6;
        let [a, b, c] =
            [(); 3].map(|()| (away + random.position(4.0)).map(|x| (x * 1024.0).round() / 1024.0));
        if (b - a).cross(&(c - a)).norm() < 1.0 {
            continue;
        }
        let circle = Circle::through(point(a), point(b), point(c)).expect("apart");
        let circle = circle.circle().expect("no line");
        let (from_a, radius) = oracle::circumcircle(a - a, b - a, c - a);
        let miss = (plain(circle.center().expect("round").position()) - a - from_a).norm();
        assert!(miss < 1e-8, "{miss:e}");
        let miss = (circle.radius_squared().expect("round") - radius * radius).abs();
        assert!(miss < 5e-3 * (1.0 + radius), "{miss:e}");
    }
}

/// The weight of an element does not change what it is, not even near the ends of the range.
#[test]
fn queries_do_not_depend_on_the_weight() {
    let center = Point::at(1.0, -2.0, 0.5);
    let circle = Circle::with_normal(center, 1.5, Vector3::new(1.0, 2.0, 2.0)).expect("a normal");
    let line = Line::along(center, Vector3::new(1.0, 2.0, 2.0));
    for exponent in [-1000, -500, -100, -30, 30, 100, 500, 1000] {
        let heavy: Circle = circle * 2_f64.powi(exponent);
        assert_eq!(heavy.center(), circle.center());
        assert_eq!(heavy.radius_squared(), circle.radius_squared());
        assert_eq!(heavy.surround(), circle.surround());
        let heavy: Line = line * 2_f64.powi(exponent);
        let x = Point::at(5.0, 5.0, 5.0);
        assert_eq!(heavy.nearest(x), line.nearest(x));
    }
}
