//! The conformal types do what plain vector geometry says.

use std::f64::consts::{FRAC_PI_3, PI};

use ga_cga::{
    Bivector3, DualPlane, DualSphere, Motor, Point, Rotor, Scalar, Sphere, Translator, Vector3,
};

fn samples() -> Vec<Vector3> {
    let mut state = 1_u64;
    let mut next = || {
        state = state
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        (state >> 33) as f64 / (1_u64 << 30) as f64 - 1.0
    };
    (0..50)
        .map(|_| Vector3::new(next(), next(), next()) * 3.0)
        .collect()
}

fn close(a: Vector3, b: Vector3) {
    assert!((a - b).norm() <= 1e-13 * (1.0 + b.norm()), "{a} is not {b}");
}

/// (2.45), (2.46): points are null, and their inner product is minus half the squared distance.
#[test]
fn points_are_null_and_measure_distances() {
    for pair in samples().windows(2) {
        let (a, b) = (Point::from(pair[0]), Point::from(pair[1]));
        assert!(a.norm_squared().abs() < 1e-13);
        let Scalar { s } = a | b;
        let expected = -0.5 * (pair[0] - pair[1]).norm_squared();
        assert!((s - expected).abs() < 1e-12);
        assert!((a.distance(b) - (pair[0] - pair[1]).norm()).abs() < 1e-14);
    }
}

/// (2.52): reflection in a dual sphere is inversion, and its square tells the radius.
#[test]
fn dual_spheres_invert() {
    let center = Vector3::new(0.5, -1.0, 2.0);
    let sphere = DualSphere::with_radius(center, 1.5);
    assert_eq!(sphere.radius_squared(), Some(2.25));
    assert_eq!(sphere.center(), Some(Point::from(center)));
    for x in samples() {
        let image: DualSphere = sphere.apply(Point::from(x));
        let image = image.center().expect("no sample is the centre");
        let from_center = x - center;
        close(
            image.position(),
            center + from_center * (2.25 / from_center.norm_squared()),
        );
    }
    let imaginary = DualSphere::about(Point::from(center), -4.0);
    assert_eq!(imaginary.radius_squared(), Some(-4.0));
    assert_eq!(DualSphere::<f64>::infinity().radius_squared(), None);
    assert_eq!(DualSphere::<f64>::infinity().center(), None);
}

/// A dual plane reflects, whatever its weight, and keeps the weight of points.
#[test]
fn dual_planes_reflect() {
    let normal = Vector3::new(1.0, 2.0, -2.0);
    let through = Point::at(1.0, 1.0, 0.0);
    let plane = DualPlane::through(through, normal).expect("the normal has a length");
    let heavy: DualPlane = plane * -7.0;
    for x in samples() {
        let unit = normal / 3.0;
        let height = (x - through.position()).scalar_product(unit);
        let expected = x - unit * (2.0 * height);
        let image: Point = plane.apply(Point::from(x));
        close(image.position(), expected);
        let image: Point = heavy.apply(Point::from(x));
        close(image.position(), expected);
        assert!((image.ni - 0.5 * expected.norm_squared()).abs() < 1e-12);
    }
    assert_eq!(
        DualPlane::through(through, Vector3::new(0.0, 0.0, 0.0)),
        None
    );
}

/// Table 2.6: e^{−θB/2} turns by θ in the sense of B (Rodrigues' formula).
#[test]
fn rotors_turn_in_the_sense_of_their_bivector() {
    let axis = Vector3::new(2.0, -1.0, 2.0) / 3.0;
    let rotor = Rotor::about_axis(axis, FRAC_PI_3).expect("the axis has a length");
    let cross = |a: Vector3, b: Vector3| {
        let [e12, e13, e23] = (a ^ b).to_array();
        Vector3::new(e23, -e13, e12)
    };
    for x in samples() {
        let expected = x * FRAC_PI_3.cos()
            + cross(axis, x) * FRAC_PI_3.sin()
            + axis * (axis.scalar_product(x) * (1.0 - FRAC_PI_3.cos()));
        close(rotor.apply(x), expected);
        close(rotor.apply(Point::from(x)).position(), expected);
    }
    let log: Bivector3 = rotor.log().expect("no half turn");
    assert!((log.norm() - FRAC_PI_3 / 2.0).abs() < 1e-15);
    assert_eq!(Rotor::turn(Bivector3::new(0.0, 0.0, 0.0), 1.0), None);
}

/// A motor is a translator after a rotor; motors compose to motors and invert to motors.
#[test]
fn motors_move_rigidly() {
    let rotor = Rotor::turn(Bivector3::new(0.0, 3.0, 0.0), PI / 5.0).expect("a plane");
    let shift = Vector3::new(1.0, -2.0, 0.5);
    let motor = Motor::rigid(rotor, Translator::by(shift));
    let twice: Motor = motor * motor;
    let back: Motor = motor.reverse();
    for x in samples() {
        let p = Point::from(x);
        let image: Point = motor.apply(p);
        close(image.position(), rotor.apply(x) + shift);
        close(twice.apply(p).position(), motor.apply(image).position());
        close(back.apply(image).position(), x);
    }
    assert_eq!(Translator::by(shift).vector(), shift);
    assert_eq!(
        Motor::identity().apply(Point::at(1.0, 2.0, 3.0)),
        Point::at(1.0, 2.0, 3.0)
    );
}

/// (2.49): four points span their sphere, and any fifth point of it does not add to it.
#[test]
fn four_points_span_a_sphere() {
    let on_sphere = |x: f64, y: f64, z: f64| Point::at(1.0 + 2.0 * x, 2.0 * y, 2.0 * z);
    let sphere: Sphere = on_sphere(1.0, 0.0, 0.0)
        ^ on_sphere(0.0, 1.0, 0.0)
        ^ on_sphere(0.0, 0.0, 1.0)
        ^ on_sphere(-1.0, 0.0, 0.0);
    assert!((on_sphere(0.0, 0.6, 0.8) ^ sphere).norm() < 1e-13);
    let dual: DualSphere = !sphere;
    assert!((dual.radius_squared().expect("a sphere") - 4.0).abs() < 1e-13);
    assert!(
        dual.center()
            .expect("a sphere")
            .distance(Point::at(1.0, 0.0, 0.0))
            < 1e-14
    );
}

/// The null basis keeps coordinates exact far from the origin, where e₊ and e₋ would drown them.
#[test]
fn single_precision_far_from_the_origin() {
    let shift = Translator::by(Vector3::<f32>::new(4096.0, 0.0, 0.0));
    let image: Point<f32> = shift.apply(Point::at(0.25, 0.5, 0.0));
    assert_eq!(image.position(), Vector3::new(4096.25, 0.5, 0.0));
}
