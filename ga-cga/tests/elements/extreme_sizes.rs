//! Elements made of very small and very large numbers are what they are at ordinary sizes.

use ga_cga::{
    Bivector3, Circle, Degenerate, Dilator, DualLine, DualPlane, Even, Motor, Plane, Point, Rotor,
    Sphere, Translator, Vector3,
};

/// Powers of two, so that nothing is rounded by scaling.
const SIZES: [i32; 6] = [-1000, -600, -200, 200, 500, 1000];

fn at(size: f64, x: f64, y: f64, z: f64) -> Point {
    Point::at(size * x, size * y, size * z)
}

/// A normal, a plane or an axis stands for its attitude, whatever its length.
#[test]
fn attitudes_have_any_length() {
    let place = Point::at(1.0, 2.0, 3.0);
    let (normal, other) = (Vector3::new(0.5, 0.25, -1.0), Vector3::new(-0.25, 1.0, 0.5));
    let plane = Bivector3::new(0.5, -0.25, 1.0);
    let axis = DualLine::along(place, normal);
    for size in SIZES.map(|exponent| 2_f64.powi(exponent)) {
        assert_eq!(
            DualPlane::through(place, normal * size),
            DualPlane::through(place, normal)
        );
        assert_eq!(
            Circle::with_normal(place, 2.0, normal * size),
            Circle::with_normal(place, 2.0, normal)
        );
        assert_eq!(Rotor::turn(plane * size, 1.0), Rotor::turn(plane, 1.0));
        assert_eq!(
            Rotor::about_axis(normal * size, 1.0),
            Rotor::about_axis(normal, 1.0)
        );
        assert_eq!(
            Rotor::between(normal * size, other / size),
            Rotor::between(normal, other)
        );
        assert_eq!(
            Rotor::between_in(normal * size, -normal, plane * size),
            Rotor::between_in(normal, -normal, plane)
        );
        assert_eq!(
            Motor::about_line(axis * size, 1.0),
            Motor::about_line(axis, 1.0)
        );
        assert_eq!(
            Motor::screw(axis * size, 1.0, 2.0),
            Motor::screw(axis, 1.0, 2.0)
        );
    }
}

/// A versor stands for its transformation, whatever its weight.
#[test]
fn versors_have_any_weight() {
    let turn = Rotor::about_axis(Vector3::new(1.0, 2.0, 3.0), 1.0).expect("an axis");
    let motor = Motor::rigid(turn, Translator::by(Vector3::new(1.0, -2.0, 3.0)));
    let scaled = Even::similarity(
        Dilator::scaling(4.0).expect("a factor"),
        turn,
        Translator::by(Vector3::new(1.0, -2.0, 3.0)),
    );
    for size in SIZES.map(|exponent| 2_f64.powi(exponent)) {
        let heavy: Motor = motor * size;
        assert_eq!(heavy.rotation(), motor.rotation());
        assert_eq!(heavy.translation(), motor.translation());
        assert_eq!(heavy.to_matrix(), motor.to_matrix());
        let heavy: Rotor = turn * size;
        assert_eq!(heavy.to_matrix(), turn.to_matrix());
        assert_eq!(heavy.axis(), turn.axis());
        assert!((heavy.angle() - turn.angle()).abs() < 1e-15);
        let heavy: Even = scaled * size;
        assert_eq!(
            heavy.similarity_parts(1e-9).is_some(),
            scaled.similarity_parts(1e-9).is_some()
        );
        assert_eq!(heavy.to_matrix(1e-9), scaled.to_matrix(1e-9));
    }
    // A rotation so small that the square of its plane is out of range.
    let little = Rotor::<f64>::about_axis(Vector3::new(0.0, 0.0, 1.0), 1e-200).expect("an axis");
    assert!((little.angle() - 1e-200).abs() < 1e-214);
    assert_eq!(little.axis(), Some(Vector3::new(0.0, 0.0, 1.0)));
}

/// Distances whose squares are out of range.
#[test]
fn distances_have_any_size() {
    let origin = Point::at(0.0, 0.0, 0.0);
    assert_eq!(at(1e-200, 3.0, 4.0, 0.0).distance(origin), 5e-200);
    assert_eq!(at(1e140, 3.0, 4.0, 0.0).distance(origin), 5e140);
}

/// Scalings keep the accuracy that they promise, and are refused where nothing of them is left.
#[test]
fn scalings_far_from_one() {
    for exponent in -14..=14 {
        for factor in [10_f64.powi(exponent), -3.0 * 10_f64.powi(exponent)] {
            let found = Dilator::scaling(factor).and_then(Dilator::factor);
            let miss = (found.expect("in range") / factor - 1.0).abs();
            let bound = 4.0 * f64::EPSILON * factor.abs().max(1.0 / factor.abs());
            assert!(miss <= bound, "{factor:e}: {miss:e}");
        }
    }
    for factor in [1e17, -1e30, 1e300, 1e-17, 1e-300, 5e-324, 0.0, f64::NAN] {
        assert_eq!(Dilator::scaling(factor), None, "{factor:e}");
        assert_eq!(Even::scaling(Point::at(1.0, 2.0, 3.0), factor), None);
    }
}

/// Points far apart and close together span what they span, or say that it is out of range: they
/// are not called collinear for it.
#[test]
fn points_at_any_distance() {
    let corners = |size: f64| {
        [
            at(size, 1.0, 0.0, 0.0),
            at(size, 0.0, 1.0, 0.0),
            at(size, 0.0, 0.0, 1.0),
            at(size, 0.0, 0.0, 0.0),
        ]
    };
    for size in [1e-60, 1e-30, 1e-9, 1e9, 1e30, 1e50] {
        let [a, b, c, d] = corners(size);
        let sphere = Sphere::through(a, b, c, d).expect("apart").sphere();
        let sphere = sphere.expect("not coplanar");
        let center = sphere.center().expect("round");
        assert!(center.distance(at(size, 0.5, 0.5, 0.5)) < 1e-14 * size);
        let square = sphere.radius_squared().expect("round") / (size * size);
        assert!((square - 0.75).abs() < 1e-13);
        let circle = Circle::through(a, b, c).expect("apart").circle();
        let circle = circle.expect("not collinear");
        let square = circle.radius_squared().expect("round") / (size * size);
        assert!((square - 2.0 / 3.0).abs() < 1e-13);
        let normal = Plane::through(a, b, c).expect("apart").normal();
        assert!((normal.e1 / (size * size) - 1.0).abs() < 1e-13);
    }
    for size in [1e-140, 1e-130, 1e120, 1e150] {
        let [a, b, c, d] = corners(size);
        assert_eq!(Sphere::through(a, b, c, d), Err(Degenerate::NotFinite));
        assert_eq!(Circle::through(a, b, c), Err(Degenerate::NotFinite));
    }
    let [a, b, c, _] = corners(1e-170);
    assert_eq!(Plane::through(a, b, c), Err(Degenerate::NotFinite));
}
