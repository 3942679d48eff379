//! Each reason for which there is no path, and that it says what it is.

use super::law::{neither, ways};
use crate::random::Random;
use ga_cga::interpolate::{Carry, Connect, NoPath, Way};
use ga_cga::*;
use std::error::Error;

#[test]
fn spheres_are_refused_for_the_right_reason() {
    let zero = DualSphere::<f64>::default();
    let point = DualSphere::from(Point::at(1.0, 2.0, 3.0));
    let sphere = DualSphere::with_radius(Vector3::new(0.0, 0.0, 0.0), 1.0);
    let imaginary = DualSphere::about(Point::at(0.0, 0.0, 0.0), -1.0);
    let outside = DualSphere::with_radius(Vector3::new(9.0, 0.0, 0.0), 1.0);
    let touching = DualSphere::with_radius(Vector3::new(2.0, 0.0, 0.0), 1.0);
    for (other, reason) in [
        (zero, NoPath::Null),
        (point, NoPath::DifferentKinds),
        (DualSphere::infinity(), NoPath::DifferentKinds),
        (imaginary, NoPath::RealToImaginary),
        (outside, NoPath::Reversed),
        (touching, NoPath::Reversed),
        (-sphere, NoPath::Opposite),
        (-sphere * 3.0, NoPath::Opposite),
        (sphere * f64::NAN, NoPath::NotFinite),
        (sphere * f64::INFINITY, NoPath::NotFinite),
    ] {
        assert_eq!(ways(sphere, other, 1e-9), neither(reason), "to {other}");
        assert_eq!(ways(other, sphere, 1e-9), neither(reason), "from {other}");
    }
    // An imaginary sphere is on one of two sheets.
    let other = DualSphere::about(Point::at(1.0, 0.0, 0.0), -2.0);
    assert_eq!(ways(imaginary, -other, 1e-9), neither(NoPath::Reversed));
    assert_eq!(sphere.path_to(sphere, Way::Long), Err(NoPath::DoesNotTurn));
    assert!(sphere.path_to(sphere, Way::Short).is_ok());
}

#[test]
fn flats_are_refused_for_the_right_reason() {
    let up = Vector3::new(0.0, 0.0, 1.0);
    let plane = DualPlane::at_distance(up, 1.0);
    assert_eq!(ways(plane, -plane, 1e-9), neither(NoPath::Opposite));
    let above = DualPlane::at_distance(-up, -3.0);
    assert_eq!(ways(plane, above, 1e-9), neither(NoPath::Reversed));
    let line = Line::along(Point::at(1.0, 0.0, 0.0), up);
    let beside = Line::along(Point::at(4.0, 0.0, 0.0), up);
    assert_eq!(ways(line, -line, 1e-9), neither(NoPath::Opposite));
    assert_eq!(ways(line, -beside, 1e-9), neither(NoPath::Reversed));
    assert_eq!(line.path_to(beside, Way::Long), Err(NoPath::DoesNotTurn));
    assert_eq!(ways(line, Line::default(), 1e-9), neither(NoPath::Null));
    let infinite = Line::from(DirectionBivector::of(up.orthogonal_plane()));
    assert_eq!(ways(line, infinite, 1e-9), neither(NoPath::DifferentKinds));
    assert_eq!(ways(up, -up, 1e-9), neither(NoPath::Opposite));
    assert_eq!(ways(up, Vector3::default(), 1e-9), neither(NoPath::Null));
}

#[test]
fn circles_are_refused_for_the_right_reason() {
    let at = Point::at;
    let ring: Circle = at(1.0, 0.0, 0.0) ^ at(0.0, 1.0, 0.0) ^ at(-1.0, 0.0, 0.0);
    let axis: Circle = at(0.0, 0.0, 1.0) ^ at(0.0, 0.0, 0.0) ^ DualSphere::infinity();
    assert_eq!(ways(ring, axis, 1e-9), neither(NoPath::ManyWays));
    assert_eq!(ways(ring, -ring, 1e-9), neither(NoPath::Opposite));
    assert_eq!(ways(ring, Circle::default(), 1e-9), neither(NoPath::Null));
    let imaginary =
        DualSphere::with_radius(Vector3::default(), 1.0).circle_in(Bivector3::new(1.0, 0.0, 0.0));
    assert_eq!(
        ways(ring, imaginary, 1e-9),
        neither(NoPath::RealToImaginary)
    );
}

#[test]
fn versors_are_refused_for_the_right_reason() {
    let refused = |from: Even, to: Even, reason| {
        assert_eq!(from.versor_path_to(to, Way::Short), Err(reason));
    };
    let identity = Even::from(Rotor::identity());
    refused(Even::default(), identity, NoPath::Null);
    refused(identity, Even::default(), NoPath::Null);
    refused(identity, identity * f64::NAN, NoPath::NotFinite);
    let mirrored = Even::from(Dilator::scaling(-2.0).expect("not zero"));
    refused(identity, mirrored, NoPath::Reversed);
    let mut random = Random::new(111);
    for _ in 0..100 {
        refused(identity, random.element(), NoPath::NotAVersor);
    }
    // As a versor the direct sphere does what the dual one does, and the reflection in all of
    // space, which is none. Real ones invert; of imaginary ones it is two half turns at once,
    // in planes of which there are many pairs.
    let sphere = |square| Even::from(DualSphere::about(Point::at(0.0, 0.0, 0.0), square).undual());
    refused(identity, sphere(1.0), NoPath::Reversed);
    refused(identity, sphere(-1.0), NoPath::ManyWays);
    let still = identity.versor_path_to(identity, Way::Long);
    assert_eq!(still, Err(NoPath::DoesNotTurn));
    // The generator of a screw is no line.
    let screw = DualLine::new(1.0, 0.0, 0.0, 0.0, 0.0, 0.5);
    let line = DualLine::new(0.0, 1.0, 0.0, 0.0, 0.0, 0.0);
    assert_eq!(ways(line, screw, 1e-9), neither(NoPath::NotAVersor));
    let null = Odd::from(DualSphere::<f64>::infinity());
    assert_eq!(null.versor_path_to(null, Way::Short), Err(NoPath::Null));
}

/// Each reason in a sentence of its own, as an error.
#[test]
fn reasons_can_be_read() {
    let reasons = [
        NoPath::Null,
        NoPath::NotFinite,
        NoPath::RealToImaginary,
        NoPath::DifferentKinds,
        NoPath::Reversed,
        NoPath::Opposite,
        NoPath::ManyWays,
        NoPath::DoesNotTurn,
        NoPath::NotAVersor,
        NoPath::Imprecise,
    ];
    let said = reasons.map(|reason| Box::<dyn Error>::from(reason).to_string());
    for (i, words) in said.iter().enumerate() {
        assert!(words.len() > 20 && !said[..i].contains(words), "{words}");
    }
}
