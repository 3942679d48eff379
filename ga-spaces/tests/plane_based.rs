//! Plane-based algebras against plain vector geometry.
#![cfg(feature = "plane-based")]

use ga_core::Rational;
use ga_spaces::plane_based2 as flat;
use ga_spaces::plane_based3::{
    Direction, IdealLine, Line, Motor, OriginLine, Place, Plane, Point, Rotor, Translator,
    WeightedPoint,
};
use nalgebra::{Isometry3, Point3, Translation3, Unit, UnitQuaternion, Vector3};
use proptest::prelude::*;

type Space = [f64; 3];

fn position() -> impl Strategy<Value = Space> {
    [-5.0..5.0, -5.0..5.0, -5.0..5.0]
}

fn direction() -> impl Strategy<Value = Space> {
    position().prop_filter("a direction", |d| Vector3::from(*d).norm() > 1e-2)
}

fn point([x, y, z]: Space) -> Point {
    Point::at(x, y, z)
}

fn near(a: Space, b: Space, tolerance: f64) -> Result<(), TestCaseError> {
    let miss = (Vector3::from(a) - Vector3::from(b)).norm();
    prop_assert!(
        miss <= tolerance * (1.0 + Vector3::from(b).norm()),
        "{a:?} is not {b:?}"
    );
    Ok(())
}

fn close(a: f64, b: f64, tolerance: f64) -> Result<(), TestCaseError> {
    prop_assert!(
        (a - b).abs() <= tolerance * (1.0 + b.abs()),
        "{a} is not {b}"
    );
    Ok(())
}

fn exact() -> impl Strategy<Value = Rational> {
    (-9_i128..=9, 1_i128..=4).prop_map(|(n, d)| Rational::new(n, d))
}

fn exact_point() -> impl Strategy<Value = Point<Rational>> {
    (exact(), exact(), exact()).prop_map(|(x, y, z)| Point::at(x, y, z))
}

fn exact_plane() -> impl Strategy<Value = Plane<Rational>> {
    (exact(), exact(), exact(), exact()).prop_map(|(a, b, c, d)| Plane::new(a, b, c, d))
}

proptest! {
    /// Where three planes meet, all three equations hold, by Cramer's rule and exactly.
    #[test]
    fn three_planes_meet_in_a_point(p in exact_plane(), q in exact_plane(), r in exact_plane()) {
        let met: WeightedPoint<Rational> = p ^ q ^ r;
        let zero = Rational::from_integer(0);
        let normals = [p, q, r].map(|plane| [plane.e1, plane.e2, plane.e3]);
        let [a, b, c] = normals;
        let determinant = a[0] * (b[1] * c[2] - b[2] * c[1])
            - a[1] * (b[0] * c[2] - b[2] * c[0])
            + a[2] * (b[0] * c[1] - b[1] * c[0]);
        match met.place() {
            Place::Point(point) => {
                prop_assert_ne!(determinant, zero);
                let [x, y, z] = point.to_array();
                for plane in [p, q, r] {
                    let value = plane.e1 * x + plane.e2 * y + plane.e3 * z + plane.e0;
                    prop_assert_eq!(value, zero);
                }
            }
            Place::Direction(towards) => {
                prop_assert_eq!(determinant, zero);
                let [x, y, z] = towards.to_array();
                for [a, b, c] in normals {
                    prop_assert_eq!(a * x + b * y + c * z, zero);
                }
            }
            Place::Nowhere => prop_assert_eq!(determinant, zero),
        }
    }

    /// The plane joined of three points holds them, and its normal is the cross product.
    #[test]
    fn three_points_join_in_a_plane(a in exact_point(), b in exact_point(), c in exact_point()) {
        let plane: Plane<Rational> = a & b & c;
        for point in [a, b, c] {
            prop_assert_eq!((plane ^ point).e0123, Rational::from_integer(0));
        }
        let minus = |p: Point<Rational>, q: Point<Rational>| {
            [p.e032 - q.e032, p.e013 - q.e013, p.e021 - q.e021]
        };
        let (u, v) = (minus(b, a), minus(c, a));
        prop_assert_eq!(plane.e1, u[1] * v[2] - u[2] * v[1]);
        prop_assert_eq!(plane.e2, u[2] * v[0] - u[0] * v[2]);
        prop_assert_eq!(plane.e3, u[0] * v[1] - u[1] * v[0]);
    }

    /// The line joined of two points is the one from the first to the second, exactly: its
    /// direction is their difference, its moment their cross product.
    #[test]
    fn two_points_join_in_a_line(a in exact_point(), b in exact_point()) {
        let line: Line<Rational> = a & b;
        prop_assert_eq!([line.e23, line.e31, line.e12], [b.e032 - a.e032, b.e013 - a.e013, b.e021 - a.e021]);
        let [x, y, z] = a.to_array();
        let [u, v, w] = b.to_array();
        let moment = [y * w - z * v, z * u - x * w, x * v - y * u];
        prop_assert_eq!([line.e01, line.e02, line.e03], moment);
    }

    /// Rotation about a line and translation are nalgebra's.
    #[test]
    fn motors_are_isometries(
        through in position(), along in direction(), angle in -6.0..6.0_f64, shift in position(), x in position(),
    ) {
        let axis = Unit::new_normalize(Vector3::from(along));
        let turn = UnitQuaternion::from_axis_angle(&axis, angle);
        let to = Translation3::from(Vector3::from(through));
        let isometry: Isometry3<f64> =
            Translation3::from(Vector3::from(shift)) * (to * turn * to.inverse());
        let ahead = (Vector3::from(through) + Vector3::from(along)).into();
        let line: Line = point(through) & point(ahead);
        let rotation = Motor::about(line, angle).expect("a finite line");
        let [dx, dy, dz] = shift;
        let motor: Motor = Translator::by(dx, dy, dz) * rotation;
        let image: Point = motor.apply(point(x));
        near(image.to_array(), (isometry * Point3::from(x)).coords.into(), 1e-12)?;
        // A direction turns and does not move.
        let far: Direction = motor.apply(Direction::new(x[0], x[1], x[2]));
        near(far.to_array(), (isometry * Vector3::from(x)).into(), 1e-12)?;
        // A plane through the point stays through it.
        let plane = Plane::through(point(x), Direction::new(dx, dy, dz));
        if let Some(plane) = plane {
            let moved: Plane = motor.apply(plane);
            close(moved.signed_distance(image).expect("finite"), 0.0, 1e-11)?;
        }
        // The motor back.
        let back: Point = motor.reverse().apply(image);
        near(back.to_array(), x, 1e-12)?;
    }

    /// The exponential of axis and shift along it is a screw.
    #[test]
    fn screws_turn_and_shift(along in direction(), angle in -6.0..6.0_f64, pitch in -3.0..3.0_f64, x in position()) {
        let axis = Unit::new_normalize(Vector3::from(along));
        let [a, b, c]: Space = axis.into_inner().into();
        let half = -0.5;
        let turn = Line::from(OriginLine::new(a, b, c) * (half * angle));
        let shift = Line::from(IdealLine::new(a, b, c) * (half * pitch));
        let image: Point = Motor::screw(turn + shift).apply(point(x));
        let turned: Vector3<f64> =
            UnitQuaternion::from_axis_angle(&axis, angle) * Vector3::from(x);
        let screwed: Vector3<f64> = turned + axis.into_inner() * pitch;
        near(image.to_array(), screwed.into(), 1e-12)?;
        let rotor = Rotor::about(OriginLine::new(a, b, c), angle).expect("an axis");
        let image: Point = rotor.apply(point(x));
        near(image.to_array(), turned.into(), 1e-12)?;
    }

    /// The logarithm of a motor built from an isometry is the line of its screw: the axis times
    /// minus half the angle, and minus half the shift along it; and back.
    #[test]
    fn logarithms_of_motors_are_screws(
        through in position(), along in direction(), angle in -6.2..6.2_f64, pitch in -3.0..3.0_f64, x in position(),
    ) {
        prop_assume!(angle.abs() > 1e-3);
        let axis = Unit::new_normalize(Vector3::from(along));
        let to = Translation3::from(Vector3::from(through));
        let turn = UnitQuaternion::from_axis_angle(&axis, angle);
        let shift = Vector3::from(axis.into_inner() * pitch);
        let isometry: Isometry3<f64> = Translation3::from(shift) * (to * turn * to.inverse());
        let [dx, dy, dz]: Space = isometry.translation.vector.into();
        let rotor = Rotor::about(OriginLine::new(axis.x, axis.y, axis.z), angle).expect("an axis");
        let motor: Motor = Translator::by(dx, dy, dz) * rotor;
        let log: Line = motor.log().expect("no full turn");
        // Direction and moment of the axis, by vector geometry alone.
        let moment = Vector3::from(through).cross(&axis) * angle + shift;
        let expected = axis.into_inner() * (-0.5 * angle);
        near([log.e23, log.e31, log.e12], expected.into(), 1e-12)?;
        near([log.e01, log.e02, log.e03], (moment * -0.5).into(), 1e-9)?;
        let back = Motor::screw(log);
        for (a, b) in back.to_array().into_iter().zip(motor.to_array()) {
            close(a, b, 1e-12)?;
        }
        // The root moves half of the way, twice.
        let root = motor.sqrt().expect("no full turn");
        let once: Point = root.apply(point(x));
        let half = Translation3::from(shift * 0.5)
            * (to * UnitQuaternion::from_axis_angle(&axis, 0.5 * angle) * to.inverse());
        near(once.to_array(), (half * Point3::from(x)).coords.into(), 1e-9)?;
        let twice: Point = root.apply(once);
        near(twice.to_array(), (isometry * Point3::from(x)).coords.into(), 1e-9)?;
    }

    /// Reflection in a plane, and in two planes one after the other.
    #[test]
    fn planes_reflect(through in position(), normal in direction(), x in position()) {
        let plane = Plane::through(point(through), Direction::new(normal[0], normal[1], normal[2]))
            .expect("a normal");
        let unit = Vector3::from(normal).normalize();
        let height = (Vector3::from(x) - Vector3::from(through)).dot(&unit);
        close(plane.signed_distance(point(x)).expect("finite"), height, 1e-12)?;
        // V x̂ V⁻¹ turns the orientation of a point with its place: weight −1.
        let image: WeightedPoint = plane.apply(point(x));
        let Place::Point(image) = image.place() else {
            return Err(TestCaseError::fail("the image of a point is a point"));
        };
        near(image.to_array(), (Vector3::from(x) - unit * (2.0 * height)).into(), 1e-11)?;
    }

    /// Distances and angles of lines and points.
    #[test]
    fn measures_agree(a in position(), u in direction(), b in position(), v in direction()) {
        let line = |p: Space, d: Space| -> Line {
            point(p) & point((Vector3::from(p) + Vector3::from(d)).into())
        };
        let (one, two) = (line(a, u), line(b, v));
        let (p, u, q, v) = (Vector3::from(a), Vector3::from(u), Vector3::from(b), Vector3::from(v));
        close(point(a).distance(point(b)), (p - q).norm(), 1e-13)?;
        let cross = u.cross(&v);
        prop_assume!(cross.norm() > 1e-2);
        let expected = (q - p).dot(&cross).abs() / cross.norm();
        close(one.distance(two).expect("finite"), expected, 1e-9)?;
        close(one.angle(two).expect("finite"), u.angle(&v), 1e-11)?;
        let expected = (q - p).cross(&u).norm() / u.norm();
        close(one.distance_to_point(point(b)).expect("finite"), expected, 1e-11)?;
    }

    /// Distance and angle of planes against their normals.
    #[test]
    fn planes_enclose_the_angle_of_their_normals(u in direction(), v in direction()) {
        let plane = |n: Space| Plane::new(n[0], n[1], n[2], 1.0);
        let angle = plane(u).angle(plane(v)).expect("finite");
        close(angle, Vector3::from(u).angle(&Vector3::from(v)), 1e-12)?;
    }

    /// In the plane: join, meet, motors.
    #[test]
    fn the_plane_moves_rigidly(a in [-5.0..5.0, -5.0..5.0], b in [-5.0..5.0, -5.0..5.0], angle in -6.0..6.0_f64) {
        let (p, q) = (flat::Point::at(a[0], a[1]), flat::Point::at(b[0], b[1]));
        close(p.distance(q), (a[0] - b[0]).hypot(a[1] - b[1]), 1e-13)?;
        let image: flat::Point = flat::Motor::about(p, angle).apply(q);
        let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
        let (sin, cos) = angle.sin_cos();
        close(image.e20, a[0] + cos * dx - sin * dy, 1e-12)?;
        close(image.e01, a[1] + sin * dx + cos * dy, 1e-12)?;
        let motor = flat::Motor::about(p, angle);
        let log = motor.log().expect("no full turn");
        close(log.e12, -0.5 * angle, 1e-12)?;
        close(log.e20, -0.5 * angle * a[0], 1e-11)?;
        close(log.e01, -0.5 * angle * a[1], 1e-11)?;
        let root = motor.sqrt().expect("no full turn");
        let half = flat::Motor::about(p, 0.5 * angle);
        for (a, b) in root.to_array().into_iter().zip(half.to_array()) {
            close(a, b, 1e-11)?;
        }
        let moved: flat::Point = flat::Translator::by(a[0], a[1]).apply(q);
        close(moved.e20, a[0] + b[0], 1e-13)?;
        close(moved.e01, a[1] + b[1], 1e-13)?;
        let line: flat::Line = p & q;
        prop_assume!(p.distance(q) > 1e-2);
        let height = line.signed_distance(flat::Point::at(0.0, 0.0)).expect("finite");
        close(height, (a[0] * b[1] - a[1] * b[0]) / p.distance(q), 1e-10)?;
        let level = flat::Line::new(0.0, 1.0, 0.0);
        close(level.angle(line).expect("finite"), dy.atan2(dx).abs(), 1e-11)?;
    }
}

/// Translations have the line at infinity as logarithm, the identity zero, and minus the identity
/// none, as minus a translation.
#[test]
fn logarithms_of_translations() {
    for shift in [
        [1.0, -2.0, 0.5],
        [1e-9, 0.0, 3e-9],
        [4e5, 1e5, -7e5],
        [0.0; 3],
    ] {
        let [x, y, z] = shift;
        let motor = Motor::from(Translator::by(x, y, z));
        let generator = IdealLine::new(-0.5 * x, -0.5 * y, -0.5 * z);
        assert_eq!(motor.log(), Some(Line::from(generator)));
        assert_eq!(Translator::by(x, y, z).log(), Some(generator));
        assert_eq!(Motor::screw(Line::from(generator)), motor);
        let half = Motor::from(Translator::by(0.5 * x, 0.5 * y, 0.5 * z));
        assert_eq!(motor.sqrt(), Some(half));
        assert_eq!((-motor).log(), None);
        assert_eq!((-motor).sqrt(), None);
        let flat = flat::Motor::from(flat::Translator::by(x, y));
        let direction = flat::Direction::new(0.5 * y, -0.5 * x);
        assert_eq!(flat.log(), Some(flat::WeightedPoint::from(direction)));
        assert_eq!((-flat).log(), None);
    }
    assert_eq!(Motor::<f64>::default().log(), None);
    assert_eq!(flat::Motor::<f64>::default().sqrt(), None);
}

/// Lines that are parallel up to the rounding of their coordinates have the distance of parallel
/// lines: the sine of their angle, which is rounding error, is not divided by.
#[test]
fn nearly_parallel_lines_have_a_distance() {
    for i in 0..1000 {
        let number = |k: u32| (f64::from(i * 7 + k) * 0.731).sin();
        let along = [number(1), number(2), number(3)];
        let [a, b] = [[number(4), number(5), number(6)], [0.3, -1.2, 2.0]];
        let line = |p: Space, scale: f64| -> Line {
            let q: Space = std::array::from_fn(|i| p[i] + scale * along[i]);
            point(p) & point(q)
        };
        let [u, p, q] = [along, a, b].map(Vector3::from);
        let expected = (q - p).cross(&u.normalize()).norm();
        for scale in [1.0, -3.7] {
            let found = line(a, 1.0).distance(line(b, scale)).expect("lines");
            assert!(
                (found - expected).abs() < 1e-13,
                "{found} is not {expected}"
            );
        }
        // A thousandth of a degree off, they pass each other at a point.
        let off = Vector3::new(number(7), number(8), number(9)) * 2e-5;
        let tilted: Line = point(b) & point((q + u + off).into());
        let across = u.cross(&(u + off)).normalize();
        let found = line(a, 1.0).distance(tilted).expect("lines");
        assert!((found - across.dot(&(q - p)).abs()).abs() < 1e-8, "{found}");
    }
}

/// Parallel lines have a distance, also where they coincide; anti-parallel ones too.
#[test]
fn parallel_lines_have_a_distance() {
    let line = |x: f64, y: f64| -> Line { Point::at(x, y, 1.0) & Point::at(x, y, 3.0) };
    assert_eq!(line(0.0, 0.0).distance(line(3.0, 4.0)), Some(5.0));
    assert_eq!(line(0.0, 0.0).distance(-line(3.0, 4.0)), Some(5.0));
    assert_eq!(line(1.0, 1.0).distance(line(1.0, 1.0)), Some(0.0));
    assert_eq!(
        line(0.0, 0.0).angle(-line(3.0, 4.0)),
        Some(std::f64::consts::PI)
    );
}

/// What is at infinity, or nothing at all, has its own answer.
#[test]
fn degenerate_elements_are_told_apart() {
    let infinity = Plane::new(0.0, 0.0, 0.0, 1.0);
    let floor = Plane::new(0.0, 0.0, 1.0, 0.0);
    assert_eq!(infinity.signed_distance(Point::at(1.0, 2.0, 3.0)), None);
    assert_eq!(infinity.angle(floor), None);
    assert_eq!(floor.angle(infinity), None);
    assert_eq!(
        Plane::through(Point::at(1.0, 2.0, 3.0), Direction::new(0.0, 0.0, 0.0)),
        None
    );
    // Parallel planes meet in a line at infinity, and with a third in a direction.
    let ceiling = Plane::new(0.0, 0.0, 1.0, -2.0);
    let wall = Plane::new(1.0, 0.0, 0.0, 0.0);
    let line: Line = floor ^ ceiling;
    assert_eq!(line, Line::from(IdealLine::new(0.0, 0.0, 2.0)));
    assert_eq!(Motor::about(line, 1.0), None);
    assert_eq!(line.distance(floor ^ wall), None);
    assert_eq!(line.distance_to_point(Point::at(0.0, 0.0, 0.0)), None);
    assert!(matches!((line ^ wall).place(), Place::Direction(_)));
    assert_eq!((line ^ floor).place(), Place::Nowhere);
    assert_eq!(Rotor::about(OriginLine::new(0.0, 0.0, 0.0), 1.0), None);
    let lines = [
        flat::Line::new(0.0, 1.0, 0.0),
        flat::Line::new(0.0, 1.0, -3.0),
    ];
    assert_eq!(
        (lines[0] ^ lines[1]).place(),
        flat::Place::Direction(flat::Direction::new(-3.0, 0.0))
    );
    assert_eq!((lines[0] ^ lines[0]).place(), flat::Place::Nowhere);
    assert_eq!(flat::Line::new(0.0, 0.0, 1.0).angle(lines[0]), None);
    assert_eq!(
        flat::Line::new(0.0, 0.0, 1.0).signed_distance(flat::Point::at(0.0, 0.0)),
        None
    );
}
