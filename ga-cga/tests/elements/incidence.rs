//! Meets, joins, containment and projections against plain vector geometry.

use std::f64::consts::FRAC_PI_2;

use ga_cga::incidence::{
    angle, contains, contains_within, distance, join, meet, nearest, plunge, project, reject,
};
use ga_cga::{
    Circle, Classification, Direction, DirectionBivector, DirectionVector, DualLine, DualPlane,
    DualSphere, Flat, FlatPoint, Line, Multivector, Plane, Point, PointPair, Round, Shape, Sphere,
    SplitPair, Tangent, classify,
};
use ga_core::Element;

use super::oracle::{self, Position, Random, close, near, place, plain, point, rounding, vector};

use Classification::{Direct, Dual};

/// Whether a classification fits a pattern.
macro_rules! is {
    ($x:expr, $pattern:pat) => {{
        let found = $x;
        assert!(matches!(found, $pattern), "{found:?}");
    }};
}

/// (2.25): where the elements span space, the meet is (A*∧B*)⁻* with its sign and weight.
#[test]
fn equation_2_25_meets_are_undualised_products_of_duals() {
    let mut random = Random::new(60);
    for _ in 0..500 {
        let sphere = Sphere::about(point(random.position(1.0)), 4.0);
        let plane = Plane::with_normal(point(random.position(1.0)), vector(random.direction()));
        let line = Line::along(
            point(random.position(1.0)),
            vector(random.direction() * 3.0),
        );
        let circle =
            Circle::with_normal(point(random.position(1.0)), 2.0, vector(random.direction()))
                .expect("a normal");
        let same = |found: Classification<f64>, printed: Multivector| {
            let shape = found.shape().expect("an element");
            let mut found = Multivector::from(shape);
            if matches!(classify(printed), Dual(_)) {
                found = found.dual();
            }
            let miss = oracle::distance(found, printed);
            assert!(
                miss < 1e-11 * (1.0 + oracle::size(printed)),
                "{found} is not {printed}"
            );
        };
        same(
            meet(sphere, plane),
            (sphere.dual() ^ plane.dual()).undual().into(),
        );
        same(
            meet(plane, line),
            (plane.dual() ^ line.dual()).undual().into(),
        );
        same(
            meet(line, sphere),
            (line.dual() ^ sphere.dual()).undual().into(),
        );
        same(
            meet(circle, plane),
            (circle.dual() ^ plane.dual()).undual().into(),
        );
        same(meet(circle, circle), circle.into());
        same(plunge(sphere, plane), (sphere.dual() ^ plane.dual()).into());
    }
}

/// Two planes: a line, a direction, or the plane itself.
#[test]
fn planes_meet_in_lines() {
    let mut random = Random::new(61);
    for _ in 0..2000 {
        let at = place(&mut random);
        let (n, m) = (random.direction(), random.direction());
        let along = n.cross(&m);
        if along.norm() < 0.05 {
            continue;
        }
        let (one, two) = (
            Plane::with_normal(point(at), vector(n)),
            DualPlane::at_distance(vector(m), m.dot(&at)),
        );
        let Some(line) = meet(one, two).line() else {
            panic!("{:?}", meet(one, two));
        };
        close(line.direction(), along, 1e-7);
        let foot = plain(line.nearest(point(at)).expect("a line").position());
        assert!((foot - at).norm() < 100.0 * rounding(at) / along.norm());

        let beside = Plane::with_normal(point(at + n * 3.0), vector(n * 2.0));
        let shared = meet(one, beside).direction_bivector().expect("parallel");
        assert!(plain(shared.bivector().normal()).cross(&n).norm() < 1e-6 * shared.weight());
        let again: Plane = one * -5.0;
        assert_eq!(meet(one, again).plane(), Some(one));
        assert_eq!(join(one, again).plane(), Some(one));
        is!(join(one, two), Direct(Shape::Flat(Flat::Space(_))));
    }
}

/// Sphere and plane: a real, touching or imaginary circle (Figure 2.10), near and far.
#[test]
fn equation_2_56_spheres_meet_planes() {
    let mut random = Random::new(62);
    for _ in 0..2000 {
        let at = place(&mut random);
        let (n, r) = (random.direction(), 1.0 + at.norm() * random.signed().abs());
        for (height, real) in [(0.5 * r, true), (-0.9 * r, true), (1.5 * r, false)] {
            let plane = DualPlane::at_distance(vector(n), n.dot(&at) + height);
            let sphere = DualSphere::with_radius(vector(at), r);
            let found = meet(sphere, plane);
            let circle = found.circle().expect("a circle");
            assert_eq!(found.is_real_round(), real);
            let center = plain(circle.center().expect("round").position());
            assert!((center - (at + n * height)).norm() < 1e-13 * (at.norm() + r));
            let square = circle.radius_squared().expect("round");
            assert!((square - (r * r - height * height)).abs() < 1e-13 * (at.norm() + r).powi(2));
            // (2.56) as printed.
            let printed: Circle = (sphere ^ plane).undual();
            assert!(oracle::distance(printed, circle) < 1e-12 * oracle::size(printed));
        }
        let plane = DualPlane::at_distance(vector(n), n.dot(&at) + r);
        let sphere = DualSphere::with_radius(vector(at), r);
        is!(
            meet(sphere, plane),
            Direct(Shape::Tangent(Tangent::Bivector(_)))
        );
    }
}

/// Lines: crossing, parallel, skew, the same; in a plane, beside it, through it.
#[test]
fn lines_meet_what_they_meet() {
    let mut random = Random::new(63);
    for _ in 0..2000 {
        let at = place(&mut random);
        let (t, u) = (random.direction(), random.direction());
        if t.cross(&u).norm() < 0.1 {
            continue;
        }
        let one = Line::along(point(at), vector(t));
        let away = at + u * 2.0;
        let two = DualLine::along(point(away), vector(u));
        let crossing = meet(one, two).flat_point().expect("a flat point");
        let found = plain(crossing.location().expect("finite").position());
        assert!(
            (found - at).norm() < 1e3 * rounding(at),
            "{:e}",
            (found - at).norm()
        );
        assert!(join(one, two).plane().is_some());

        let beside = Line::along(point(at + u), vector(t * -2.0));
        let shared = meet(one, beside).direction_vector().expect("parallel");
        assert!(plain(shared.vector()).cross(&t).norm() < 1e-6 * shared.weight());
        assert!(join(one, beside).plane().is_some());

        let skew = Line::along(point(at + t.cross(&u)), vector(u));
        is!(
            meet(one, skew),
            Direct(Shape::Direction(Direction::Infinity(_)))
        );
        assert_eq!(meet(one, one * 3.0).line(), Some(one));

        let n = t.cross(&u).normalize();
        let plane = Plane::with_normal(point(at), vector(n));
        assert_eq!(meet(plane, one).line(), Some(one));
        assert_eq!(meet(one, plane).line(), Some(one));
        assert_eq!(join(one, plane).plane(), Some(plane));
        let above = Plane::with_normal(point(at + n), vector(n));
        assert!(meet(one, above).direction_vector().is_some());
        let across = Line::along(point(at), vector(n + t));
        let piercing = meet(across, above).flat_point().expect("a flat point");
        let found = plain(piercing.location().expect("finite").position());
        assert!((found - (at + n + t)).norm() < 1e3 * rounding(at));
    }
}

/// Circles in one plane meet in pairs, circles that share two points too; linked ones in none.
#[test]
fn circles_meet_in_pairs() {
    let mut random = Random::new(64);
    for _ in 0..1000 {
        let (at, n) = (random.position(100.0), random.direction());
        let t = n.cross(&random.direction()).normalize();
        let circle =
            |x: Position, r: f64| Circle::with_normal(point(x), r, vector(n)).expect("a normal");
        let (one, two) = (circle(at, 2.0), circle(at + t * 2.5, 1.5));
        let found = meet(one, two);
        let pair = found.point_pair().expect("a pair");
        let SplitPair::Real { first, second } = pair.split() else {
            panic!("{found:?}");
        };
        let x = (2.5 * 2.5 + 4.0 - 2.25) / 5.0;
        let y = (4.0_f64 - x * x).sqrt();
        let middle = at + t * x;
        let expected = [middle + n.cross(&t) * y, middle - n.cross(&t) * y];
        for end in [first, second] {
            let end = plain(end.position());
            let miss = expected.map(|e| (e - end).norm());
            assert!(miss[0].min(miss[1]) < 1e-9, "{miss:?}");
        }
        is!(
            meet(one, circle(at + t * 4.0, 2.0)),
            Direct(Shape::Tangent(Tangent::Vector(_)))
        );
        is!(
            meet(one, circle(at + t * 9.0, 2.0)),
            Direct(Shape::ImaginaryRound(Round::PointPair(_)))
        );
        is!(
            meet(one, circle(at, 1.0)),
            Direct(Shape::Flat(Flat::Point(_))) | Dual(_)
        );
        let plane = one.carrier();
        assert_eq!(meet(plane, one).circle(), Some(one));
        assert_eq!(meet(one, plane).circle(), Some(one));
        assert_eq!(join(one, plane).plane(), Some(plane));
        assert!(join(one, two).plane().is_some());
        let on = point(at + t * 2.0);
        assert!(
            meet(one, on)
                .point()
                .is_some_and(|p| p.distance(on) < 1e-12)
        );
        is!(meet(one, point(at)), Classification::Number(_));
        let sphere = join(one, point(at + n * 2.0)).sphere().expect("a sphere");
        near(sphere.radius_squared().expect("round"), 4.0, 1e-9, "join");
    }
}

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

/// Whatever the elements: an answer, without panic and without NaN.
#[test]
fn any_two_elements_have_answers() {
    let mut random = Random::new(72);
    let mut any = |round: usize| -> Shape<f64> {
        loop {
            let spread = [2.0, 8.0, 100.0][round % 3];
            let [a, b, c] = [(); 3].map(|()| {
                DualSphere::from_fn(|_| {
                    if random.signed() < -0.5 {
                        0.0
                    } else {
                        random.signed() * 10_f64.powf(spread * random.signed())
                    }
                })
            });
            let x: Multivector = match round % 5 {
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
    };
    let sane = |class: Classification<f64>| {
        if let Some(shape) = class.shape() {
            let x = Multivector::from(shape);
            assert!((0..32).all(|i| !x.at(i).is_nan()), "{class:?}");
        }
    };
    for round in 0..1500 {
        let (a, b) = (any(round), any(round / 5));
        sane(meet(a, b));
        sane(join(a, b));
        sane(plunge(a, b));
        project(a, b).into_iter().chain(reject(a, b)).for_each(sane);
        contains(a, b);
        for number in [angle(a, b), distance(a, b)].into_iter().flatten() {
            assert!(number.is_finite(), "{a:?} {b:?}");
        }
        if let Some(p) = nearest(a, Point::at(1.0, 2.0, 3.0)) {
            assert!(!p.position().norm().is_nan());
        }
    }
    let (zero, point) = (PointPair::<f64>::default(), Point::at(1.0, 2.0, 3.0));
    let broken = point.map(|_| f64::NAN);
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
