//! Joins, containment, projections and plunges against plain vector geometry.

use std::f64::consts::FRAC_PI_2;

use ga_cga::incidence::{
    angle, contains, contains_within, distance, join, meet, nearest, plunge, project, reject,
};
use ga_cga::{
    Circle, Classification, DirectionBivector, DirectionVector, DualPlane, DualSphere, FlatPoint,
    Line, Multivector, Plane, PointPair, Round, Shape, Sphere, classify,
};

use super::oracle::{self, Random, close, place, point, vector};

use Classification::{Direct, Dual};

/// Joins of points are the constructions (2.47)–(2.51).
#[test]
fn points_join_to_rounds() {
    let mut random = Random::new(65);
    for _ in 0..1000 {
        let [a, b, c] = [(); 3].map(|()| random.position(3.0));
        if (b - a).cross(&(c - a)).norm() < 0.5 {
            continue;
        }
        let pair: PointPair = point(a) ^ point(b);
        let joined = join(point(a), point(b)).point_pair().expect("a pair");
        assert!(oracle::distance(joined, pair) < 1e-13 * oracle::size(pair));
        let circle: Circle = pair ^ point(c);
        let joined = join(pair, point(c)).circle().expect("a circle");
        assert!(oracle::distance(joined, circle) < 1e-12 * oracle::size(circle));
        let line = join(FlatPoint::at(point(a)), point(b))
            .line()
            .expect("a line");
        assert!(contains(line, point(a)) && contains(line, point(b)) && !contains(line, point(c)));
        let plane = join(line, point(c)).plane().expect("a plane");
        assert!(contains(plane, circle));
        assert_eq!(join(circle, point(a)).circle(), Some(circle));
        assert_eq!(join(point(a), point(a)).point(), Some(point(a)));
    }
}

/// What lies in what, to rounding, near and far; and what does not.
#[test]
fn containment() {
    let mut random = Random::new(66);
    for _ in 0..1000 {
        let (at, n) = (place(&mut random), random.direction());
        let t = n.cross(&random.direction()).normalize();
        let plane = DualPlane::at_distance(vector(n), n.dot(&at));
        let line = Line::along(point(at), vector(t));
        let circle = Circle::with_normal(point(at), 1.0, vector(n)).expect("a normal");
        let sphere = DualSphere::with_radius(vector(at), 1.0);
        let on = point(at + t);
        for (inside, name) in [
            (contains(plane, line), "line in plane"),
            (contains(plane, circle), "circle in plane"),
            (contains(plane, on), "point in plane"),
            (contains(line, on), "point in line"),
            (contains(line, FlatPoint::at(on)), "flat point in line"),
            (
                contains(line, DirectionVector::along(vector(t))),
                "direction in line",
            ),
            (contains(sphere, circle), "circle in sphere"),
            (contains(sphere, on), "point in sphere"),
            (contains(circle, on), "point in circle"),
            (contains(circle, circle), "circle in itself"),
            (
                contains(line, PointPair::about(point(at), 1.0, vector(t))),
                "pair in line",
            ),
            (
                contains(
                    sphere,
                    Circle::tangent(point(at + n), vector(n).orthogonal_plane()),
                ),
                "tangent in sphere",
            ),
            (
                contains(plane, DirectionBivector::of(vector(n).orthogonal_plane())),
                "direction in plane",
            ),
        ] {
            assert!(inside, "{name} at {:e}", at.norm());
        }
        // The bound that rounding sets, and a margin.
        let margin = 0.01 + 1e-12 * at.norm_squared();
        let off = point(at + n * margin + t * (1.0 + margin));
        for (inside, name) in [
            (contains(plane, off), "point off plane"),
            (contains(line, off), "point off line"),
            (contains(sphere, off), "point off sphere"),
            (contains(circle, off), "point off circle"),
            (contains(line, plane), "plane in line"),
            (contains(plane, sphere), "sphere in plane"),
            (
                contains(plane, DirectionVector::along(vector(n))),
                "normal in plane",
            ),
            (contains(circle, line), "line in circle"),
        ] {
            assert!(!inside, "{name} at {:e}", at.norm());
        }
        if at.norm() < 100.0 {
            assert!(contains_within(plane, point(at + t + n * 1e-4), 1e-3));
            assert!(!contains_within(plane, point(at + t + n * 1e-1), 1e-3));
        }
    }
}

/// (2.26)–(2.30): projection and rejection add up, and are what Euclid projects.
#[test]
fn equations_2_26_to_2_30_projection_and_rejection() {
    let mut random = Random::new(70);
    for _ in 0..1000 {
        let (at, n, t) = (
            random.position(10.0),
            random.direction(),
            random.direction(),
        );
        let x = random.position(10.0);
        if t.cross(&n).norm() < 0.1 {
            continue;
        }
        let plane = Plane::with_normal(point(at), vector(n * 2.0));
        let sphere = Sphere::about(point(at), 4.0);
        let line = Line::along(point(x), vector(t));
        let shadow = project(line, plane)
            .and_then(Classification::line)
            .expect("a line");
        close(shadow.direction(), t - n * n.dot(&t), 1e-12);
        let foot = x - n * n.dot(&(x - at));
        assert!(distance(shadow, point(foot)).is_some_and(|d| d < 1e-11));

        // (2.26): a vector is the sum of its parts, and the parts are at right angles.
        let p = DualSphere::from(point(x));
        let parts = [project(point(x), sphere), reject(point(x), sphere)].map(|part| {
            let part: Multivector = match part.expect("the sphere is no tangent") {
                Direct(shape) => shape.into(),
                Dual(shape) => Multivector::from(shape).dual(),
                other => panic!("{other:?}"),
            };
            part.narrow::<DualSphere>(1e-9).expect("a vector")
        });
        let [inside, outside] = parts;
        assert!(oracle::distance(inside + outside, p) < 1e-10 * oracle::size(p));
        assert!(inside.scalar_product(outside).abs() < 1e-10 * oracle::size(p).powi(2));
        let Some(Dual(
            Shape::RealRound(Round::Sphere(about)) | Shape::ImaginaryRound(Round::Sphere(about)),
        )) = project(point(x), plane)
        else {
            panic!("a sphere about the foot");
        };
        close(about.center().expect("round").position(), foot, 1e-11);
        close(
            nearest(plane, point(x)).expect("a plane").position(),
            foot,
            1e-12,
        );

        assert_eq!(project(point(x), point(at)), None);
        assert_eq!(reject(line, PointPair::tangent(point(at), vector(t))), None);
        assert_eq!(project(line, DirectionVector::along(vector(t))), None);
        assert_eq!(reject(shadow, plane), Some(Classification::Zero));
    }
}

/// The plunge cuts both at right angles.
#[test]
fn plunges_are_orthogonal() {
    let mut random = Random::new(71);
    for _ in 0..1000 {
        let [a, b, c] = [(); 3].map(|()| random.position(3.0));
        let spheres = [(a, 1.0), (b, 1.5)].map(|(c, r)| DualSphere::with_radius(vector(c), r));
        let [one, two] = spheres;
        let Some(pair) = plunge(one, two).point_pair() else {
            continue;
        };
        // Section 6.3.8: the circle orthogonal to two spheres through a point.
        let circle: Circle = pair ^ point(c);
        if !classify(circle).is_real_round() {
            continue;
        }
        for sphere in spheres {
            let Some(found) = angle(circle, sphere) else {
                panic!("the circle crosses the sphere");
            };
            assert!((found - FRAC_PI_2).abs() < 1e-6);
        }
    }
}

/// Single precision answers alike.
#[test]
fn single_precision() {
    let up = ga_cga::Vector3::<f32>::new(0.0, 0.0, 1.0);
    let ground = DualPlane::at_distance(up, 0.0);
    let ball = DualSphere::with_radius(ga_cga::Vector3::new(10.0_f32, 0.0, 0.5), 1.0);
    let waterline = meet(ball, ground).circle().expect("a circle");
    let square = waterline.radius_squared().expect("round");
    assert!((square - 0.75).abs() < 1e-4);
    assert!(contains(ground, waterline));
    assert_eq!(distance(ball, DualPlane::at_distance(up, 3.5)), Some(2.0));
}
