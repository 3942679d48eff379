//! What is asked of an element is what went into it: round trips, far places, and odd input.

use ga_cga::{
    Circle, DirectionBivector, DirectionVector, DualPlane, DualSphere, FlatPoint, Line, Plane,
    Point, PointPair, Sphere, SplitPair, TangentBivector, TangentVector, Vector3,
};

use super::oracle::{self, Random, close, near, plain, point, vector};

/// How many random elements of each kind make the trip.
const TRIPS: usize = 100_000;

/// A factor of either sign between 1e−3 and 1e3.
fn weight(random: &mut Random) -> f64 {
    random.signed().signum() * 10_f64.powf(3.0 * random.signed())
}

/// Construct, query, construct; dual and undual: the same element again.
#[test]
fn rounds_come_back_from_their_queries() {
    let mut random = Random::new(20);
    for _ in 0..TRIPS {
        let center = random.position(10.0);
        let radius_squared = 25.0 * random.signed();
        let heavy = weight(&mut random);
        let attitude = vector(random.direction() * heavy);

        let pair = PointPair::about(point(center), radius_squared, attitude);
        let again = PointPair::about(
            pair.center().expect("round"),
            pair.radius_squared().expect("round"),
            pair.attitude().vector(),
        );
        assert!(oracle::distance(pair, again) <= 1e-12 * oracle::size(pair));
        assert_eq!(pair.dual().undual(), pair);
        near(pair.weight(), heavy.abs(), 1e-14, "weight");

        let circle = Circle::about(point(center), radius_squared, attitude.orthogonal_plane());
        let again = Circle::about(
            circle.center().expect("round"),
            circle.radius_squared().expect("round"),
            circle.attitude().bivector(),
        );
        assert!(oracle::distance(circle, again) <= 1e-12 * oracle::size(circle));
        assert_eq!(circle.dual().undual(), circle);
        near(circle.weight(), heavy.abs(), 1e-14, "weight");

        let sphere: Sphere = Sphere::about(point(center), radius_squared) * heavy;
        let again: Sphere = Sphere::about(
            sphere.center().expect("round"),
            sphere.radius_squared().expect("round"),
        ) * sphere.attitude().trivector().e123;
        assert!(oracle::distance(sphere, again) <= 1e-12 * oracle::size(sphere));
        assert_eq!(sphere.dual().undual(), sphere);

        let dual: DualSphere = DualSphere::about(point(center), radius_squared) * heavy;
        let again: DualSphere = DualSphere::about(
            dual.center().expect("round"),
            dual.radius_squared().expect("round"),
        ) * dual.weight();
        assert!(oracle::distance(dual, again) <= 1e-12 * oracle::size(dual));
        assert_eq!(dual.undual().dual(), dual);
    }
}

/// (2.57) corrected: the points of a pair, in order, whatever its weight.
#[test]
fn equation_2_57_pairs_split_in_order() {
    let mut random = Random::new(21);
    for _ in 0..TRIPS {
        let (a, b) = (random.position(10.0), random.position(10.0));
        if (a - b).norm() < 0.5 {
            continue;
        }
        let heavy = weight(&mut random);
        let pair: PointPair = (point(a) ^ point(b)) * heavy;
        let SplitPair::Real { first, second } = pair.split() else {
            panic!("two points apart");
        };
        let (start, end) = if heavy > 0.0 { (a, b) } else { (b, a) };
        close(first.position(), start, 3e-12);
        close(second.position(), end, 3e-12);
    }
}

/// Imaginary and touching pairs are told apart, and say where they are.
#[test]
fn equation_2_57_imaginary_and_tangent_pairs() {
    let mut random = Random::new(22);
    for _ in 0..10_000 {
        let (at, t) = (random.position(10.0), random.direction() * 3.0);
        let radius_squared = -0.01 - 9.0 * random.signed().abs();
        match PointPair::about(point(at), radius_squared, vector(t)).split() {
            SplitPair::Imaginary {
                center,
                radius_squared: found,
                direction,
            } => {
                close(center.position(), at, 1e-13);
                assert!((found - radius_squared).abs() < 1e-11);
                close(direction, t, 1e-14);
            }
            other => panic!("{other:?} is not imaginary"),
        }
        match PointPair::tangent(point(at), vector(t)).split() {
            SplitPair::Tangent { point, direction } => {
                close(point.position(), at, 1e-13);
                close(direction, t, 1e-14);
            }
            other => panic!("{other:?} is not tangent"),
        }
        match PointPair::from(FlatPoint::at(point(at))).split() {
            SplitPair::WithInfinity(point) => close(point.position(), at, 1e-15),
            other => panic!("{other:?} is not flat"),
        }
    }
    assert!(matches!(
        PointPair::<f64>::default().split(),
        SplitPair::NoPair(_)
    ));
}

/// (2.58): dualising gives the two points in the order in which the line meets them.
#[test]
fn equation_2_58_line_through_sphere() {
    let mut random = Random::new(23);
    for _ in 0..10_000 {
        let (center, t) = (random.position(4.0), random.direction());
        let across = random.direction().cross(&t).normalize();
        let (r, h) = (2.0, 1.9 * random.signed());
        let middle = center + across * h;
        let line = Line::along(point(middle + t * random.signed()), vector(t * 1.5));
        let sphere = DualSphere::with_radius(vector(center), r);
        let pair: PointPair = (line.dual() ^ sphere).dual();
        let SplitPair::Real { first, second } = pair.split() else {
            panic!("the line meets the sphere");
        };
        let half = (r * r - h * h).sqrt();
        close(first.position(), middle - t * half, 1e-11);
        close(second.position(), middle + t * half, 1e-11);
    }
}

/// (2.60), (2.61): X/(−n_∞⌋X) is the imaginary, X/(X∧n_∞) the real surround, up to weight.
#[test]
fn equations_2_60_and_2_61_surrounds() {
    let mut random = Random::new(24);
    let infinity = DualSphere::infinity();
    for _ in 0..1000 {
        let center = random.position(4.0);
        let radius_squared = 0.1 + 4.0 * random.signed().abs();
        let t = vector(random.direction());
        let pair = PointPair::about(point(center), radius_squared, t);
        let circle = Circle::about(point(center), radius_squared, t.orthogonal_plane());
        let sphere = Sphere::about(point(center), radius_squared);
        let vector_part = |quotient: ga_cga::Multivector| -> DualSphere {
            quotient.narrow(1e-10).expect("a vector")
        };
        let printed_2_60 = [
            vector_part((pair / -(infinity << pair)).into()),
            vector_part((circle / -(infinity << circle)).into()),
        ];
        for surround in printed_2_60 {
            let found = surround.radius_squared().expect("a sphere");
            assert!(
                (found + radius_squared).abs() < 1e-10,
                "(2.60) is the imaginary one"
            );
            close(
                surround.center().expect("a sphere").position(),
                center,
                1e-11,
            );
        }
        // The squared radius X²/(X∧n_∞)², negated for circles.
        let squares = [
            (pair.norm_squared(), pair.carrier().norm_squared(), 1.0),
            (circle.norm_squared(), circle.carrier().norm_squared(), -1.0),
            (sphere.norm_squared(), sphere.carrier().norm_squared(), 1.0),
        ];
        // X X̃ is X² or −X² by the grade; the signs of X and its carrier differ but for circles.
        let squared = |grade: u32, reverse: f64| if grade % 4 < 2 { reverse } else { -reverse };
        for (grade, (own, carrier, sign)) in (2..).zip(squares) {
            let found = sign * squared(grade, own) / squared(grade + 1, carrier);
            assert!((found - radius_squared).abs() < 1e-11, "grade {grade}");
        }
        let printed_2_61 = [
            (
                vector_part((pair / pair.carrier()).into()),
                pair.surround(),
                -1.0,
            ),
            (
                vector_part((circle / circle.carrier()).into()),
                circle.surround(),
                1.0,
            ),
            (
                vector_part((sphere / sphere.carrier()).into()),
                sphere.surround(),
                -1.0,
            ),
        ];
        for (printed, surround, sign) in printed_2_61 {
            near(
                printed.weight(),
                sign,
                1e-13,
                "(2.61): the weight has to be divided out",
            );
            let surround = surround.expect("a sphere");
            near(surround.weight(), 1.0, 1e-15, "normalised");
            assert!(oracle::distance(printed * sign, surround) < 1e-10, "(2.61)");
            let found = surround.radius_squared().expect("a sphere");
            assert!(
                (found - radius_squared).abs() < 1e-11,
                "(2.61) is the real one"
            );
        }
    }
}

/// Tangents at any point come back from their queries, and in their own types at the origin.
#[test]
fn tangents_come_back_from_their_queries() {
    let mut random = Random::new(29);
    for _ in 0..TRIPS {
        let at = point(random.position(10.0));
        let t = vector(random.direction() * weight(&mut random));
        let pair = PointPair::tangent(at, t);
        let again = PointPair::tangent(pair.center().expect("round"), pair.attitude().vector());
        assert!(oracle::distance(pair, again) <= 1e-12 * oracle::size(pair));
        let plane = t.orthogonal_plane();
        let circle = Circle::tangent(at, plane);
        let place = circle.center().expect("round");
        let again = Circle::tangent(place, circle.attitude().bivector());
        assert!(oracle::distance(circle, again) <= 1e-12 * oracle::size(circle));
        let sphere = Sphere::tangent(at);
        let again = Sphere::tangent(sphere.center().expect("round"));
        assert!(oracle::distance(sphere, again) <= 1e-12 * oracle::size(sphere));
        for square in [
            pair.radius_squared(),
            circle.radius_squared(),
            sphere.radius_squared(),
        ] {
            assert!(
                square.expect("round").abs() < 1e-12,
                "a tangent has radius zero"
            );
        }
        let (own, own_plane) = (
            TangentVector::at_origin(t),
            TangentBivector::at_origin(plane),
        );
        assert_eq!(own.vector(), t);
        assert_eq!(own_plane.bivector(), plane);
        assert_eq!(own.dual().undual(), own);
        assert_eq!(own_plane.dual().undual(), own_plane);
        let (direction, level) = (DirectionVector::along(t), DirectionBivector::of(plane));
        assert_eq!(direction.dual().undual(), direction);
        assert_eq!(level.dual().undual(), level);
    }
}

/// Flats come back from a point on them and their attitude.
#[test]
fn flats_and_directions_come_back_from_their_queries() {
    let mut random = Random::new(25);
    for _ in 0..TRIPS {
        let (at, elsewhere) = (point(random.position(10.0)), point(random.position(10.0)));
        let heavy = weight(&mut random);
        let t = vector(random.direction() * heavy);

        let line = Line::along(at, t);
        let again = Line::along(line.nearest(elsewhere).expect("a line"), line.direction());
        assert!(oracle::distance(line, again) <= 1e-12 * oracle::size(line));
        assert_eq!(line.dual().undual(), line);
        assert_eq!(line.dual().attitude(), line.attitude());
        near(line.weight(), heavy.abs(), 1e-14, "weight");

        let plane = Plane::with_normal(at, t);
        let again = Plane::with_normal(plane.nearest(elsewhere).expect("a plane"), plane.normal());
        assert!(oracle::distance(plane, again) <= 1e-12 * (1.0 + oracle::size(plane)));
        assert_eq!(plane.dual().undual(), plane);
        let dual = plane.dual();
        assert_eq!(dual.normal(), plane.normal());
        assert_eq!(dual.attitude(), plane.attitude());
        let distance = dual.distance_from_origin().expect("a plane");
        let again = DualPlane::at_distance(dual.normal() / dual.weight(), distance);
        assert!(oracle::distance(dual / dual.weight(), again) <= 1e-12 * 20.0);

        let flat: FlatPoint = FlatPoint::at(at) * heavy;
        assert!(flat.location().expect("a place").distance(at) < 1e-14);
        assert_eq!(flat.weight(), heavy);
        close(
            flat.nearest(elsewhere).expect("a place").position(),
            plain(at.position()),
            1e-13,
        );

        assert_eq!(DirectionVector::along(t).vector(), t);
        assert_eq!(
            DirectionBivector::of(t.orthogonal_plane())
                .bivector()
                .normal(),
            t
        );
        assert_eq!(TangentVector::at_origin(t).vector(), t);
        assert_eq!(
            TangentBivector::at_origin(t.orthogonal_plane())
                .bivector()
                .normal(),
            t
        );
    }
}

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

/// Single precision works alike.
#[test]
fn single_precision() {
    let pair: PointPair<f32> = Point::at(1.0_f32, 2.0, 3.0) ^ Point::at(1.0, 2.0, 7.0);
    assert_eq!(pair.center(), Some(Point::at(1.0, 2.0, 5.0)));
    let SplitPair::Real { first, second } = pair.split() else {
        panic!("two points");
    };
    assert!(first.distance(Point::at(1.0, 2.0, 3.0)) < 1e-5);
    assert!(second.distance(Point::at(1.0, 2.0, 7.0)) < 1e-5);
    let heavy: PointPair<f32> = pair * 1e30;
    assert_eq!(heavy.center(), Some(Point::at(1.0, 2.0, 5.0)));
}

/// Lanes answer like the numbers in them.
#[cfg(feature = "wide")]
#[test]
fn lanes() {
    use wide::f64x4;
    let xs = f64x4::new([0.0, 1.0, -2.0, 1e6]);
    let pair: PointPair<f64x4> =
        Point::at(xs, xs, f64x4::splat(0.0)) ^ Point::at(xs, xs, f64x4::splat(4.0));
    let center = pair.center().expect("round").position().to_array();
    assert_eq!(center, [xs, xs, f64x4::splat(2.0)]);
    let squares = pair.radius_squared().expect("round").to_array();
    assert!(squares.iter().all(|square| (square - 4.0).abs() < 1e-2));
    let line = Line::along(Point::at(xs, xs, xs), pair.attitude().vector());
    let foot = line
        .nearest(Point::at(xs, xs, f64x4::splat(7.0)))
        .expect("a line");
    assert_eq!(foot.position().to_array(), [xs, xs, f64x4::splat(7.0)]);
}
