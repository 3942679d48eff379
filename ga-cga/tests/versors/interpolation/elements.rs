//! Paths from element to element (2.66, 2.67).

use crate::random::{Random, size};
use ga_cga::interpolate::{Carry, Continuous, ElementPath, Way};
use ga_cga::*;
use ga_core::ops::{Element, NormSquared};

/// The element over its norm.
fn unit<X>(x: X) -> X
where
    X: Element<Number = f64> + NormSquared<Output = f64>,
{
    let norm = x.norm_squared().abs().sqrt();
    X::from_fn(|i| x.at(i) / norm)
}

/// The element over its largest coefficient: what it is without its weight.
fn shape<X: Element<Number = f64>>(x: X) -> X {
    let largest = size(x);
    X::from_fn(|i| x.at(i) / largest)
}

fn apart<X: Element<Number = f64>>(a: X, b: X) -> f64 {
    size(X::from_fn(|i| a.at(i) - b.at(i)))
}

/// The path of an element starts at it and ends at the target, whichever way it goes.
fn carries<X>(from: X, to: X, tolerance: f64) -> u32
where
    X: Carry + Element<Number = f64> + core::fmt::Debug,
    X::Versor: Continuous<Number = f64>,
{
    let mut ways = 0;
    for way in [Way::Short, Way::Long] {
        let Some(path) = from.path_to(to, way) else {
            continue;
        };
        ways += 1;
        assert!(apart(shape(path.at(0.0)), shape(from)) < tolerance);
        let end = path.at(1.0);
        assert!(
            apart(shape(end), shape(to)) < tolerance,
            "{from:?} goes to {end:?}, not {to:?}, by {:?}",
            path.generator()
        );
        // From the middle of the short way the same versor leads to the end.
        if way == Way::Short {
            let middle = path.at(0.5);
            let rest = ElementPath::along(middle, path.versor_at(0.5), Way::Short);
            let rest = rest.map(|rest| shape(rest.at(1.0)));
            assert!(rest.is_some_and(|rest| apart(rest, shape(end)) < tolerance));
        }
    }
    ways
}

#[test]
fn flats_and_directions_are_carried() {
    let mut random = Random::new(81);
    let infinity = DualSphere::infinity();
    for _ in 0..3_000 {
        let mut p = || random.point();
        let lines: [Line; 2] = [p() ^ p() ^ infinity, p() ^ p() ^ infinity]
            .map(|line| line.narrow(1e-12).expect("a line"));
        let planes: [Plane; 2] = [p() ^ p() ^ p() ^ infinity, p() ^ p() ^ p() ^ infinity]
            .map(|plane| plane.narrow(1e-12).expect("a plane"));
        let flats: [FlatPoint; 2] =
            [p() ^ infinity, p() ^ infinity].map(|flat| flat.narrow(1e-12).expect("a flat point"));
        assert_eq!(carries(lines[0], lines[1], 1e-9), 2);
        assert_eq!(carries(lines[0].dual(), lines[1].dual(), 1e-9), 2);
        assert_eq!(carries(planes[0], planes[1], 1e-9), 2);
        let duals: [DualPlane; 2] = planes.map(Plane::dual);
        assert_eq!(carries(duals[0], duals[1], 1e-9), 2);
        assert_eq!(carries(flats[0], flats[1], 1e-10), 1);
        let (a, b) = (p(), p());
        let path = a.path_to(b, Way::Short).expect("points always");
        let third = a.position() * (2.0 / 3.0) + b.position() / 3.0;
        assert!((path.at(1.0 / 3.0).position() - third).norm() < 1e-14);

        let (u, v): (Vector3, Vector3) = (random.direction(), random.direction());
        assert_eq!(carries(u, v, 1e-12), 2);
        let [f, g] = [u, v].map(|u| DirectionVector::from(u.to_array()));
        let end = f.versor_to(g).expect("not opposite").apply(f);
        assert!(apart(end, g) < 1e-13);
        let [f, g] = [u, v].map(|u| TangentBivector::from(u.to_array()));
        let end = f.versor_to(g).expect("not opposite").apply(f);
        assert!(apart(end, g) < 1e-13);
    }
}

/// Crossing lines are joined by the screw about their common perpendicular: by their angle and
/// their distance.
#[test]
fn lines_are_joined_by_their_common_perpendicular() {
    let infinity = DualSphere::infinity();
    let line = |a: [f64; 3], b: [f64; 3]| -> DualLine {
        let [a, b] = [a, b].map(|[x, y, z]| Point::at(x, y, z));
        let line: Line = (a ^ b ^ infinity).narrow(0.0).expect("a line");
        line.dual()
    };
    let along_x = line([0.0, 0.0, 0.0], [1.0, 0.0, 0.0]);
    let above = line([0.0, 0.0, 2.0], [0.0, 1.0, 2.0]);
    let path = along_x.path_to(above, Way::Short).expect("not opposite");
    let motor = path.versor_at(1.0);
    let image = motor.apply(Point::at(1.0, 0.0, 0.0));
    assert!(image.distance(Point::at(0.0, 1.0, 2.0)) < 1e-14);
    let half_way = path.versor_at(0.5).apply(Point::at(0.0, 0.0, 0.0));
    assert!(half_way.distance(Point::at(0.0, 0.0, 1.0)) < 1e-14);
}

/// (5.3.5): spheres, real to real and imaginary to imaginary; outside one another they need the
/// orientations that look away from each other.
#[test]
fn spheres_are_carried() {
    let mut random = Random::new(82);
    let mut gone = 0;
    for _ in 0..5_000 {
        let (a, b) = (random.sphere(), random.sphere());
        let same_kind = (a.norm_squared() > 0.0) == (b.norm_squared() > 0.0);
        let ways = carries(a, b, 1e-7) + carries(a, -b, 1e-7);
        let duals = carries(a.undual(), b.undual(), 1e-7) + carries(a.undual(), -b.undual(), 1e-7);
        assert_eq!(ways, duals);
        if same_kind {
            // Crossing spheres go all four ways, the others one.
            let cosine = unit(a).scalar_product(unit(b));
            let expected = if cosine.abs() < 1.0 { 4 } else { 1 };
            assert_eq!(ways, expected, "{cosine}: {a} and {b}");
        } else {
            assert_eq!(ways, 0);
        }
        gone += ways;
    }
    assert!(gone > 3_000, "{gone}");
}

/// Crossing spheres turn about the circle in which they meet: every sphere of the path contains it.
#[test]
fn crossing_spheres_turn_about_their_circle() {
    let a = DualSphere::with_radius(Vector3::new(0.0, 0.0, 0.0), 2.0);
    let b = DualSphere::with_radius(Vector3::new(2.0, 0.0, 0.0), 1.5);
    let path = a.path_to(b, Way::Short).expect("they cross");
    let meet = unit(a ^ b);
    for i in 0..=8 {
        let sphere: DualSphere = path.at(f64::from(i) / 8.0);
        assert!(size((sphere ^ meet).grade(3)) < 1e-13);
    }
}

#[test]
fn circles_and_pairs_are_carried() {
    let mut random = Random::new(83);
    let mut gone = 0;
    for _ in 0..5_000 {
        let mut p = || random.point();
        let circles: [Circle; 2] = [p() ^ p() ^ p(), p() ^ p() ^ p()];
        let pairs: [PointPair; 2] = [p() ^ p(), p() ^ p()];
        for sign in [1.0, -1.0] {
            gone += carries(circles[0], circles[1] * sign, 1e-6);
            gone += carries(pairs[0], pairs[1] * sign, 1e-6);
        }
    }
    assert!(gone > 10_000, "{gone}");
}

/// (5.16) as corrected: a circle goes to its axis and to circles that are linked with it at a
/// right angle, by the way that a point chooses.
#[test]
fn orthogonal_circles_are_carried_as_a_point_chooses() {
    let mut random = Random::new(84);
    let at = Point::at;
    let ring: Circle = at(1.0, 0.0, 0.0) ^ at(0.0, 1.0, 0.0) ^ at(-1.0, 0.0, 0.0);
    let axis: Circle = at(0.0, 0.0, 1.0) ^ at(0.0, 0.0, 0.0) ^ DualSphere::infinity();
    for _ in 0..2_000 {
        // Any conformal image of a ring and its axis.
        let bend = Transversor::by(random.vector());
        let versor = random.motor() * bend;
        let [from, to]: [Circle; 2] = [ring, axis].map(|circle| unit(versor.apply(circle)));
        // Rounding may find one of the ways.
        let found = from.versor_to(to);
        assert!(found.is_none_or(|v| apart(unit(v.apply(from)), to) < 1e-6));
        let nearest = random.point();
        let chosen = from
            .versor_to_orthogonal(to, nearest)
            .unwrap_or_else(|| panic!("{from} and {to} are orthogonal near {nearest}"));
        let end = unit(chosen.apply(from));
        assert!(
            apart(end, to) < 1e-9 * (1.0 + size(to)),
            "{end} is not {to}"
        );
        let path = ElementPath::along(from, chosen, Way::Short).expect("a quarter turn twice");
        assert!(apart(unit(path.at(1.0)), to) < 1e-8 * (1.0 + size(to)));
    }
    let far: Circle = at(5.0, 0.0, 0.0) ^ at(6.0, 1.0, 0.0) ^ at(7.0, 0.0, 0.0);
    assert_eq!(ring.versor_to_orthogonal(far, at(0.0, 0.0, 1.0)), None);
    assert_eq!(ring.versor_to_orthogonal(ring, at(0.0, 0.0, 1.0)), None);
    assert_eq!(
        ring.versor_to_orthogonal(Circle::default(), at(0.0, 0.0, 1.0)),
        None
    );
}

#[test]
fn what_cannot_be_carried_is_refused() {
    let zero = DualSphere::<f64>::default();
    let point = DualSphere::from(Point::at(1.0, 2.0, 3.0));
    let sphere = DualSphere::with_radius(Vector3::new(0.0, 0.0, 0.0), 1.0);
    let imaginary = DualSphere::about(Point::at(0.0, 0.0, 0.0), -1.0);
    for (a, b) in [
        (zero, sphere),
        (sphere, zero),
        (point, sphere),
        (sphere, point),
        (sphere, imaginary),
        (sphere, -sphere),
    ] {
        assert_eq!(a.versor_to(b), None, "{a} to {b}");
    }
    let up = Vector3::new(0.0, 0.0, 1.0);
    assert_eq!(up.versor_to(-up), None);
    assert_eq!(up.versor_to(Vector3::default()), None);
    assert_eq!(Line::<f64>::default().versor_to(Line::default()), None);
    assert_eq!(Circle::<f64>::default().versor_to(Circle::default()), None);
}
