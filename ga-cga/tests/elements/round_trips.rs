//! Construct, query, construct, and dual, undual: the same element again, for every kind.

use ga_cga::{
    Circle, DirectionBivector, DirectionVector, DualPlane, DualSphere, FlatPoint, Line, Plane,
    PointPair, Sphere, TangentBivector, TangentVector,
};

use super::oracle::{self, Random, TRIPS, close, near, plain, point, vector, weight};

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
