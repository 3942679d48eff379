//! Rotations, translations and screws (2.31–2.38, 2.62–2.65), against plain vector geometry.

use crate::random::{Random, size};
use ga_cga::{
    Bivector3, Circle, DualLine, DualSphere, Line, Motor, Multivector, Point, Rotor, Translator,
    Vector3,
};
use std::f64::consts::{FRAC_PI_2, PI};

fn cross(a: Vector3, b: Vector3) -> Vector3 {
    let [e12, e13, e23] = (a ^ b).to_array();
    Vector3::new(e23, -e13, e12)
}

/// Rodrigues' formula: a turn about a unit axis through the origin.
fn rodrigues(axis: Vector3, angle: f64, x: Vector3) -> Vector3 {
    let (sin, cos) = angle.sin_cos();
    x * cos + cross(axis, x) * sin + axis * (axis.scalar_product(x) * (1.0 - cos))
}

/// (2.31): two reflections in vectors at an angle φ turn by 2φ from the first to the second.
#[test]
fn two_reflections_turn_by_twice_their_angle() {
    let mut random = Random::new(11);
    for _ in 0..1000 {
        let (b, c, x) = (random.direction(), random.direction(), random.vector());
        let rotor: Rotor = c * b;
        let angle = 2.0 * b.scalar_product(c).clamp(-1.0, 1.0).acos();
        let expected = rodrigues(cross(b, c) / cross(b, c).norm(), angle, x);
        assert!((rotor.apply(x) - expected).norm() < 1e-12);
        let one_by_one: Vector3 = c.apply(b.apply(x));
        assert!((rotor.apply(x) - one_by_one).norm() < 1e-13);
    }
}

/// (2.32), (2.33): e^{Bθ} = cos θ + B sin θ for a unit 2-blade.
#[test]
fn euler() {
    let mut random = Random::new(12);
    for _ in 0..1000 {
        let plane: Bivector3 = random.element();
        let plane = plane / plane.norm();
        let theta = 7.0 * random.number();
        let expected = Rotor::from(plane * theta.sin()) + Rotor::identity() * theta.cos();
        assert!(((plane * theta).exp() - expected).norm() < 1e-14);
    }
}

/// (2.34), (2.35), (2.63)–(2.65): e^{−θB/2} turns by θ in the sense of B, e^{θB} by −2θ.
#[test]
fn rotors_turn_by_their_angle() {
    let mut random = Random::new(13);
    for _ in 0..1000 {
        let (axis, x) = (random.direction(), random.vector());
        let theta = 6.0 * random.number();
        let rotor = Rotor::about_axis(axis, theta).expect("a direction");
        let expected = rodrigues(axis, theta, x);
        assert!((rotor.apply(x) - expected).norm() < 1e-13);
        let plane = rotor.plane().expect("it turns");
        let reverse: Rotor = (plane * rotor.angle()).exp();
        assert!((reverse.apply(x) - rodrigues(axis, -2.0 * theta, x)).norm() < 1e-13);
        // The inverse of a unit versor is its reverse.
        let inverse = rotor.inverse().expect("a unit versor");
        assert!((inverse - rotor.reverse()).norm() < 1e-15);
        // Angle and axis tell the rotation again.
        let again = Rotor::about_axis(rotor.axis().expect("it turns"), rotor.angle());
        assert!((again.expect("an axis") - rotor).norm() < 1e-14);
    }
    assert_eq!(Rotor::<f64>::identity().plane(), None);
    assert_eq!(Rotor::<f64>::identity().angle(), 0.0);
}

/// (2.36)–(2.38): the ratio of two vectors is the square of the rotor between them.
#[test]
fn rotors_between_vectors() {
    let mut random = Random::new(14);
    for _ in 0..100_000 {
        let (a, b) = (random.direction(), random.direction());
        let Some(rotor) = Rotor::between(a * 3.0, b * 0.2) else {
            panic!("{a} and {b} are not opposite")
        };
        assert!((rotor.apply(a) - b).norm() < 1e-14, "{a} to {b}");
        assert!((rotor * rotor - b * a).norm() < 1e-13);
        assert!((rotor.norm() - 1.0).abs() < 1e-15);
        let axis = cross(a, b);
        assert!((rotor.apply(axis) - axis).norm() < 1e-14);
    }
}

/// Close to opposite vectors the rotor keeps its accuracy, and beyond that a plane is chosen.
#[test]
fn rotors_between_opposite_vectors() {
    let mut random = Random::new(15);
    for power in 1..16 {
        for _ in 0..100 {
            let a = random.direction();
            let b = random.direction() * 10_f64.powi(-power) - a;
            if let Some(rotor) = Rotor::between(a, b) {
                assert!((rotor.apply(a) - b / b.norm()).norm() < 4e-15, "{a} to {b}");
                assert!((rotor.norm() - 1.0).abs() < 1e-15);
            } else {
                assert!(power >= 15);
            }
        }
    }
    for _ in 0..1000 {
        let (a, other) = (random.direction(), random.direction());
        assert_eq!(Rotor::between(a, -a), None);
        let half_turn = Rotor::between_in(a, a * -2.0, a ^ other).expect("a plane through a");
        assert!((half_turn.apply(a) + a).norm() < 3e-15);
        // The normal of the plane is the axis.
        let axis = cross(a, other);
        assert!((half_turn.apply(axis) - axis).norm() < 1e-14);
        assert!((half_turn.angle() - PI).abs() < 3e-15);
        assert_eq!(
            Rotor::between_in(a, -a, Bivector3::new(0.0, 0.0, 0.0)),
            None
        );
    }
    let up = Vector3::new(0.0, 0.0, 1.0);
    let floor = Bivector3::new(1.0, 0.0, 0.0);
    assert_eq!(Rotor::between_in(up, -up, floor), None);
}

#[test]
fn rotors_between_planes() {
    let mut random = Random::new(16);
    for _ in 0..1000 {
        let (a, b): (Bivector3, Bivector3) = (random.element(), random.element());
        let rotor = Rotor::between_planes(a, b).expect("not opposite");
        let (a, b) = (a / a.norm(), b / b.norm());
        assert!((rotor.apply(a) - b).norm() < 1e-13);
    }
}

/// (2.62) with B² = 0, and its translator (2.4.4).
#[test]
fn translators_translate_everything() {
    let mut random = Random::new(17);
    for _ in 0..1000 {
        let (v, p, q) = (random.vector(), random.point(), random.point());
        let shift = Translator::by(v);
        assert!((shift.apply(p).position() - (p.position() + v)).norm() < 1e-15);
        assert_eq!(
            Translator::between(p, q).vector(),
            q.position() - p.position()
        );
        let line: Line = (p ^ q ^ DualSphere::infinity())
            .narrow(1e-12)
            .expect("a line");
        let moved = shift.apply(p) ^ shift.apply(q) ^ DualSphere::infinity();
        assert!((moved - Circle::from(shift.apply(line))).norm() < 1e-12);
    }
}

/// (2.4.4): e^{−θλ/2} turns about the dual line λ, e^{−(θλ + h t n_∞)/2} screws.
#[test]
fn motors_turn_about_lines_and_screw() {
    let mut random = Random::new(18);
    for _ in 0..2000 {
        let (a, axis, p) = (random.point(), random.direction(), random.point());
        let (angle, rise) = (6.0 * random.number(), 3.0 * random.number());
        let b = Point::from(a.position() + axis * 2.0);
        let line: Line = (a ^ b ^ DualSphere::infinity())
            .narrow(1e-12)
            .expect("a line");
        let dual: DualLine = line.dual();
        let around = rodrigues(axis, angle, p.position() - a.position()) + a.position();

        let turn = Motor::about_line(dual, angle).expect("a line");
        assert!((turn.apply(p).position() - around).norm() < 1e-12);
        let direct = Motor::about_direct_line(line, angle).expect("a line");
        assert!((direct - turn).norm() < 1e-14);
        let unit = dual / dual.norm();
        let exponential = (unit * (-angle / 2.0)).exp();
        let difference = Multivector::from(exponential) - Multivector::from(turn);
        assert!(size(difference) < 1e-12);

        let screw = Motor::screw(dual, angle, rise).expect("a line");
        let expected = around + axis * rise;
        assert!((screw.apply(p).position() - expected).norm() < 1e-12);

        let rotation = screw.rotation().expect("a motor");
        let translation = screw.translation().expect("a motor");
        assert!((Motor::rigid(rotation, translation) - screw).norm() < 1e-13);
    }
}

/// What is no line lends its axis; what has no direction is refused.
#[test]
fn only_lines_are_turned_about() {
    let pitched = DualLine::new(1.0, 0.0, 0.0, 0.0, 0.0, 0.7);
    let turn = Motor::about_line(pitched, FRAC_PI_2).expect("it has an axis");
    let image = turn.apply(Point::at(1.0, 0.0, 2.0));
    assert!(image.distance(Point::at(0.0, 1.0, 2.0)) < 1e-15);
    let at_infinity = DualLine::new(0.0, 0.0, 0.0, 1.0, 2.0, 3.0);
    assert_eq!(Motor::about_line(at_infinity, 1.0), None);
    assert_eq!(Motor::screw(at_infinity, 1.0, 1.0), None);
}

/// Products of motions are motions, and act one after the other.
#[test]
fn motions_compose() {
    let mut random = Random::new(19);
    for _ in 0..1000 {
        let (rotor, shift, motor) = (random.rotor(), random.translator(), random.motor());
        let p = random.point();
        let both: Rotor = rotor * rotor;
        let twice: Translator = shift * shift;
        let pairs: [(Motor, Point); 5] = [
            (rotor * shift, rotor.apply(shift.apply(p))),
            (motor * motor, motor.apply(motor.apply(p))),
            (rotor * motor, rotor.apply(motor.apply(p))),
            (both.into(), rotor.apply(rotor.apply(p))),
            (twice.into(), shift.apply(shift.apply(p))),
        ];
        for (product, expected) in pairs {
            assert!(product.apply(p).distance(expected) < 1e-12);
        }
        let mirrors: Motor = random.plane() * random.plane();
        assert!((mirrors * mirrors.reverse() - Motor::identity()).norm() < 1e-13);
    }
}

/// Single precision goes the same ways.
#[test]
fn single_precision() {
    let mut random = Random::new(20);
    for _ in 0..1000 {
        let [a, b] = [random.direction(), random.direction()].map(|v| v.map(|c| c as f32));
        let rotor = Rotor::between(a, b).expect("not opposite");
        assert!((rotor.apply(a) - b).norm() < 1e-6);
        let motor = random.motor().map(|c| c as f32);
        let matrix = motor.to_matrix().expect("a motor");
        let back = Motor::from_matrix(matrix, 1e-5).expect("a rigid motion");
        assert!(size(back - motor).min(size(back + motor)) < 3e-6);
    }
}
