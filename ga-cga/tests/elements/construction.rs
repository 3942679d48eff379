//! Elements are what plain vector geometry says that they were built from.

use super::oracle::{self, Random, circumcircle, circumsphere, close, near, point, vector};
use ga_cga::{
    Bivector3, Circle, CircleOrLine, Degenerate, DirectionBivector, DirectionVector, DualLine,
    DualPlane, DualSphere, FlatPoint, Line, Plane, Point, PointPair, Sphere, SphereOrPlane,
    TangentBivector, TangentTrivector, TangentVector, Trivector3, Vector3,
};
use nalgebra as na;

/// (2.39)–(2.43): the null basis and its Minkowski plane.
#[test]
fn equations_2_39_to_2_43_null_basis() {
    let infinity = DualSphere::<f64>::infinity();
    let origin = DualSphere::from(Point::at(0.0, 0.0, 0.0));
    let (plus, minus) = (origin - infinity * 0.5, origin + infinity * 0.5);
    assert_eq!(minus - plus, infinity, "(2.39)");
    assert_eq!((minus + plus) * 0.5, origin, "(2.39)");
    assert_eq!(plus.norm_squared(), 1.0, "(2.40): e₊ squares to 1");
    assert_eq!(minus.norm_squared(), -1.0, "(2.40): e₋ squares to −1");
    assert_eq!(plus.scalar_product(minus), 0.0, "Table 2.3");
    assert_eq!(origin.scalar_product(infinity), -1.0, "Table 2.4");
    assert_eq!((origin * infinity).s, -1.0, "(2.41)");
    let wedge = origin ^ infinity;
    assert_eq!((origin * infinity).grade(2), wedge.into(), "(2.41)");
    assert_eq!(wedge, plus ^ minus, "(2.42)");
    assert_eq!((wedge * wedge).s, 1.0, "(2.43)");
}

/// (2.44)–(2.46): points are null, and products of points are distances.
#[test]
fn equations_2_44_to_2_46_points() {
    let mut random = Random::new(1);
    for _ in 0..1000 {
        let (x, y) = (random.position(4.0), random.position(4.0));
        let (p, q) = (point(x), point(y));
        near(p.ni, 0.5 * x.norm_squared(), 1e-15, "(2.44)");
        assert!(p.norm_squared().abs() < 1e-14, "(2.45)");
        let product = p.scalar_product(q);
        assert!(
            (product + 0.5 * (x - y).norm_squared()).abs() < 1e-13,
            "(2.46)"
        );
    }
}

/// (2.47), (2.48): wedges of points have the centre, radius and attitude of Euclid's.
#[test]
fn equations_2_47_and_2_48_pairs_and_circles_through_points() {
    let mut random = Random::new(2);
    for _ in 0..2000 {
        let [a, b, c] = [(); 3].map(|()| random.position(4.0));
        let pair = PointPair::between(point(a), point(b)).expect("apart");
        close(
            pair.center().expect("round").position(),
            (a + b) / 2.0,
            1e-12,
        );
        let radius_squared = (a - b).norm_squared() / 4.0;
        let found = pair.radius_squared().expect("round");
        assert!(
            (found - radius_squared).abs() <= 1e-12 * (16.0 + radius_squared),
            "(2.47)"
        );
        close(pair.attitude().vector(), b - a, 1e-14);

        let normal = (b - a).cross(&(c - a));
        if normal.norm() < 0.1 {
            continue;
        }
        let (center, radius) = circumcircle(a, b, c);
        let circle = Circle::through(point(a), point(b), point(c));
        let Ok(CircleOrLine::Circle(circle)) = circle else {
            panic!("three points apart make a circle, not {circle:?}");
        };
        let scale = 1.0 + center.norm() + radius;
        let found = circle.center().expect("round").position();
        assert!(
            (oracle::plain(found) - center).norm() < 1e-11 * scale * scale,
            "(2.48)"
        );
        let found = circle.radius_squared().expect("round");
        assert!(
            (found - radius * radius).abs() < 1e-11 * scale.powi(3),
            "(2.48)"
        );
        close(circle.normal(), normal, 1e-12);
        let product: Circle = point(a) ^ point(b) ^ point(c);
        assert!(
            oracle::distance(product, circle) < 1e-13 * oracle::size(product),
            "(2.48)"
        );
    }
}

/// (2.49): the wedge of four points is their circumscribed sphere.
#[test]
fn equation_2_49_spheres_through_points() {
    let mut random = Random::new(3);
    for _ in 0..2000 {
        let [a, b, c, d] = [(); 4].map(|()| random.position(4.0));
        let volume = (b - a).dot(&(c - a).cross(&(d - a)));
        if volume.abs() < 0.5 {
            continue;
        }
        let (center, radius) = circumsphere(a, b, c, d);
        let sphere = Sphere::through(point(a), point(b), point(c), point(d));
        let Ok(SphereOrPlane::Sphere(sphere)) = sphere else {
            panic!("four points apart make a sphere, not {sphere:?}");
        };
        let scale = 1.0 + center.norm() + radius;
        let found = oracle::plain(sphere.center().expect("round").position());
        assert!((found - center).norm() < 1e-12 * scale * scale, "(2.49)");
        let found = sphere.radius_squared().expect("round");
        assert!(
            (found - radius * radius).abs() < 1e-12 * scale.powi(3),
            "(2.49)"
        );
        near(sphere.attitude().trivector().e123, volume, 1e-12, "(2.49)");
        let product: Sphere = point(a) ^ point(b) ^ point(c) ^ point(d);
        assert!(
            oracle::distance(product, sphere) < 1e-12 * oracle::size(product),
            "(2.49)"
        );
    }
}

/// (2.50), (2.51): wedges with infinity are lines and planes.
#[test]
fn equations_2_50_and_2_51_lines_and_planes_through_points() {
    let mut random = Random::new(4);
    let infinity = DualSphere::infinity();
    for _ in 0..1000 {
        let [a, b, c, x] = [(); 4].map(|()| random.position(4.0));
        let line = Line::through(point(a), point(b)).expect("apart");
        let product: Circle = point(a) ^ point(b) ^ infinity;
        assert!(oracle::distance(product, Circle::from(line)) < 1e-13 * oracle::size(product));
        close(line.direction(), b - a, 1e-15);
        let t = (b - a).normalize();
        let foot = a + t * t.dot(&(x - a));
        close(
            line.nearest(point(x)).expect("a line").position(),
            foot,
            1e-12,
        );
        assert_eq!(Line::along(point(a), vector(b - a)), line);
        assert_eq!(DualLine::along(point(a), vector(b - a)), line.dual());

        let normal = (b - a).cross(&(c - a));
        if normal.norm() < 0.1 {
            continue;
        }
        let plane = Plane::through(point(a), point(b), point(c)).expect("apart");
        let product: Sphere = point(a) ^ point(b) ^ point(c) ^ infinity;
        assert!(oracle::distance(product, Sphere::from(plane)) < 1e-13 * oracle::size(product));
        close(plane.normal(), normal, 1e-14);
        let n = normal.normalize();
        let foot = x - n * n.dot(&(x - a));
        close(
            plane.nearest(point(x)).expect("a plane").position(),
            foot,
            1e-11,
        );
        assert_eq!(FlatPoint::at(point(a)).location(), Some(point(a)));
        assert_eq!(FlatPoint::at(point(a)).weight(), 1.0);
    }
}

/// (2.52), (2.53): centre and squared radius of either sign in one vector.
#[test]
fn equations_2_52_and_2_53_dual_spheres() {
    let mut random = Random::new(5);
    for _ in 0..1000 {
        let center = random.position(4.0);
        let radius_squared = 9.0 * random.signed();
        let sphere = DualSphere::about(point(center), radius_squared);
        let infinity = DualSphere::infinity() * (0.5 * radius_squared);
        assert_eq!(sphere, DualSphere::from(point(center)) - infinity);
        close(sphere.center().expect("a sphere").position(), center, 1e-15);
        let found = sphere.radius_squared().expect("a sphere");
        assert!((found - radius_squared).abs() < 1e-13);
        let on = center + random.direction() * radius_squared.abs().sqrt();
        let incidence = sphere.scalar_product(point(on));
        let expected = if radius_squared < 0.0 {
            radius_squared
        } else {
            0.0
        };
        assert!(
            (incidence - expected).abs() < 1e-13,
            "real spheres alone have points"
        );
        assert_eq!(
            Sphere::about(point(center), radius_squared),
            sphere.undual()
        );
    }
}

/// (2.54): the difference of points is the dual plane that bisects them.
#[test]
fn equation_2_54_dual_planes() {
    let mut random = Random::new(6);
    for _ in 0..1000 {
        let (a, b) = (random.position(4.0), random.position(4.0));
        let bisector: DualSphere = point(b) - point(a);
        assert_eq!(bisector.no, 0.0);
        let bisector: DualPlane = bisector.narrow(0.0).expect("no n_o");
        let n = (b - a).normalize();
        close(bisector.normal(), b - a, 1e-15);
        let distance = bisector.distance_from_origin().expect("a normal");
        assert!((distance - n.dot(&(a + b)) / 2.0).abs() < 1e-12, "(2.54)");
        let middle = bisector.nearest(point(a)).expect("a plane").position();
        close(middle, (a + b) / 2.0, 1e-12);
    }
}

/// (2.55): a dual line is a bivector and a moment at right angles to its direction.
#[test]
fn equation_2_55_dual_lines() {
    let mut random = Random::new(7);
    for _ in 0..1000 {
        let (a, t) = (random.position(4.0), random.direction() * 2.0);
        let line = DualLine::along(point(a), vector(t));
        let plane = Bivector3::new(line.e12, line.e13, line.e23);
        close(plane.normal(), t, 1e-15);
        let moment = na::Vector3::new(line.e1ni, line.e2ni, line.e3ni);
        assert!(
            (moment - a.cross(&t)).norm() < 1e-14 * 8.0 || (moment + a.cross(&t)).norm() < 1e-13
        );
        close(line.direction(), t, 1e-15);
        assert!((line.weight() - 2.0).abs() < 1e-15);
        assert!(line.nearest(point(a)).expect("a line").distance(point(a)) < 1e-13);
    }
}

/// (2.59): rounds from a centre, a squared radius of either sign and a Euclidean attitude.
#[test]
fn equation_2_59_rounds_from_spheres_and_attitudes() {
    let mut random = Random::new(8);
    for _ in 0..1000 {
        let (center, t) = (random.position(4.0), random.direction());
        let radius_squared = 4.0 * random.signed();
        let pair = PointPair::about(point(center), radius_squared, vector(t) * 1.5);
        let circle = Circle::about(point(center), radius_squared, vector(t).orthogonal_plane());
        for (found, sphere) in [
            (pair.center(), pair.surround()),
            (circle.center(), circle.surround()),
        ] {
            close(found.expect("round").position(), center, 1e-14);
            let sphere = sphere.expect("round").radius_squared().expect("round");
            assert!((sphere - radius_squared).abs() < 1e-12);
        }
        close(pair.attitude().vector(), t * 1.5, 1e-15);
        close(circle.normal(), t, 1e-15);
        let sphere = DualSphere::about(point(center), radius_squared);
        let sister = sphere
            .pair_along(vector(t))
            .radius_squared()
            .expect("round");
        assert!(
            (sister + radius_squared).abs() < 1e-12,
            "imaginary from real, as printed"
        );
        if radius_squared > 0.01 {
            let r = radius_squared.sqrt();
            let through: PointPair = point(center - t * r) ^ point(center + t * r);
            let scaled: PointPair = pair * (2.0 * r / 1.5);
            assert!(oracle::distance(through, scaled) < 1e-12);
        }
    }
    let center = Point::at(1.0, 2.0, 3.0);
    let circle = Circle::with_normal(center, 2.0, Vector3::new(0.0, 0.0, 9.0)).expect("a normal");
    assert_eq!(
        circle,
        Circle::about(center, 4.0, Bivector3::new(1.0, 0.0, 0.0))
    );
    assert_eq!(Circle::with_normal(center, 2.0, Vector3::default()), None);
}

/// Table 2.6: directions and tangents are n_∞ and n_o with a Euclidean blade.
#[test]
fn directions_and_tangents_hold_their_euclidean_blades() {
    let (t, b, i) = (
        Vector3::new(1.0, -2.0, 3.0),
        Bivector3::new(4.0, 5.0, -6.0),
        Trivector3::new(7.0),
    );
    let (origin, infinity) = (Point::at(0.0, 0.0, 0.0), DualSphere::infinity());
    assert_eq!(PointPair::from(DirectionVector::along(t)), t ^ infinity);
    assert_eq!(
        Circle::from(DirectionBivector::of(b)),
        Circle::from(
            (b ^ infinity)
                .narrow::<DirectionBivector>(0.0)
                .expect("a direction")
        )
    );
    assert_eq!(PointPair::from(TangentVector::at_origin(t)), origin ^ t);
    assert_eq!(TangentVector::at_origin(t).vector(), t);
    assert_eq!(TangentBivector::at_origin(b).bivector(), b);
    assert_eq!(TangentTrivector::at_origin(i).trivector(), i);
    assert_eq!(
        PointPair::tangent(origin, t),
        TangentVector::at_origin(t).into()
    );
    assert_eq!(
        Circle::tangent(origin, b),
        TangentBivector::at_origin(b).into()
    );
    let unit = TangentTrivector::at_origin(Trivector3::new(1.0));
    assert_eq!(Sphere::tangent(origin), unit.into());
    assert_eq!(b.normal().orthogonal_plane(), b);
}

/// Points that determine less, or something else.
#[test]
fn degenerate_points() {
    let at = |x: f64, y: f64, z: f64| Point::at(1000.0 + x, y - 500.0, z);
    let [a, b, c] = [at(0.0, 0.0, 0.0), at(0.25, 0.0, 0.0), at(-3.0, 0.0, 0.0)];
    let off = at(0.0, 1.0, 0.0);
    assert_eq!(PointPair::between(a, a), Err(Degenerate::CoincidentPoints));
    assert_eq!(Line::through(b, b), Err(Degenerate::CoincidentPoints));
    let Ok(CircleOrLine::Line(line)) = Circle::through(a, b, c) else {
        panic!("collinear points make a line");
    };
    assert!((c ^ line).norm() / line.weight() < 1e-9);
    for triple in [[a, a, off], [a, off, a], [off, a, a], [a, a, a]] {
        let [p, q, r] = triple;
        assert_eq!(Circle::through(p, q, r), Err(Degenerate::CoincidentPoints));
        assert_eq!(Plane::through(p, q, r), Err(Degenerate::CoincidentPoints));
        assert_eq!(
            Sphere::through(p, q, r, b),
            Err(Degenerate::CoincidentPoints)
        );
    }
    assert_eq!(Plane::through(a, b, c), Err(Degenerate::CollinearPoints));
    assert_eq!(
        Sphere::through(a, b, c, at(9.0, 0.0, 0.0)),
        Err(Degenerate::CollinearPoints)
    );
    // Three on a line and one off it: a plane, though no circle contains them.
    assert!(matches!(
        Sphere::through(a, b, c, off),
        Ok(SphereOrPlane::Plane(_))
    ));
    let square = [
        at(1.0, 0.0, 0.0),
        at(0.0, 1.0, 0.0),
        at(-1.0, 0.0, 0.0),
        at(0.0, -1.0, 0.0),
    ];
    let [p, q, r, s] = square;
    assert_eq!(
        Sphere::through(p, q, r, s),
        Err(Degenerate::CocircularPoints)
    );
    let Ok(SphereOrPlane::Plane(plane)) = Sphere::through(p, q, r, at(0.5, 0.25, 0.0)) else {
        panic!("coplanar points make a plane");
    };
    assert!(plane.normal().e1.abs() + plane.normal().e2.abs() < 1e-9 * plane.weight());
    for bad in [f64::NAN, f64::INFINITY, 1e200] {
        let bad = Point::at(bad, 0.0, 0.0);
        assert_eq!(Circle::through(a, bad, off), Err(Degenerate::NotFinite));
        assert_eq!(Sphere::through(bad, a, off, b), Err(Degenerate::NotFinite));
    }
    let bad = Point::at(f64::NAN, 0.0, 0.0);
    assert_eq!(Line::through(a, bad), Err(Degenerate::NotFinite));
    assert_eq!(Plane::through(a, bad, b), Err(Degenerate::NotFinite));
    assert_eq!(PointPair::between(a, bad), Err(Degenerate::NotFinite));
    assert!(!Degenerate::NotFinite.to_string().is_empty());
}
