//! What elements share, against plain vector geometry.

use ga_cga::incidence::{join, meet, plunge};
use ga_cga::{
    Circle, Classification, Dilator, Direction, DualLine, DualPlane, DualSphere, Flat, Line,
    Multivector, Plane, Round, Shape, Sphere, SplitPair, Tangent, Translator, classify,
};

use super::oracle::{
    self, Position, Random, close, figures, near, place, plain, point, rounding, vector,
};

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

/// The kind of an answer, without its numbers.
fn kind(found: Classification<f64>) -> String {
    let text = format!("{found:?}");
    let end = text.find(|letter: char| letter == '{' || letter == '-' || letter.is_ascii_digit());
    text[..end.unwrap_or(text.len())].to_owned()
}

/// Figure 1.1: what elements share and span does not depend on where they are, nor on how large
/// they are.
#[test]
fn figure_1_1_answers_are_covariant() {
    let mut random = Random::new(73);
    for _ in 0..30 {
        let (ones, twos) = (figures(&mut random), figures(&mut random));
        let shift = Translator::by(vector(random.direction() * 1e4));
        let scale = Dilator::new(1.5_f64, 0.5);
        for (one, _) in &ones {
            for (two, _) in twos.iter().chain(&ones) {
                let element = |x: Multivector| classify(x).shape().expect("an element");
                let (a, b) = (element(*one), element(*two));
                let here = [kind(meet(a, b)), kind(join(a, b)), kind(plunge(a, b))];
                let far = [one, two].map(|x| element(shift.apply(*x)));
                let large = [one, two].map(|x| element(scale.apply(*x)));
                for [a, b] in [far, large] {
                    let there = [kind(meet(a, b)), kind(join(a, b)), kind(plunge(a, b))];
                    assert_eq!(here, there, "{a:?} {b:?}");
                }
            }
        }
    }
}
