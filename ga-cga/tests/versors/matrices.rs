//! Matrices by rows, and what is no matrix of a motion.

use crate::random::{Random, size};
use ga_cga::interop::MatrixError;
use ga_cga::{Even, Motor, Point, Rotor, Translator, Transversor, Vector3};
use std::f64::consts::PI;

fn transformed(matrix: [[f64; 4]; 4], p: Point) -> Point {
    let [x, y, z] = p.position().to_array();
    let [x, y, z, w] = matrix.map(|row| row[0] * x + row[1] * y + row[2] * z + row[3]);
    assert_eq!(w, 1.0);
    Point::at(x, y, z)
}

#[test]
fn matrices_of_motors_move_points_alike_and_give_the_motor_back() {
    let mut random = Random::new(51);
    for _ in 0..100_000 {
        let motor = random.motor();
        let matrix = motor.to_matrix().expect("a motor");
        let p = random.point();
        assert!(transformed(matrix, p).distance(motor.apply(p)) < 1e-13);
        let back = Motor::from_matrix(matrix, 1e-9).expect("a rigid motion");
        let same = size(back - motor).min(size(back + motor));
        assert!(same < 1e-13, "{motor} came back as {back}");
        assert!(back.s >= 0.0);
        let even = Even::from_matrix(matrix, 1e-9).expect("a similarity");
        assert!(
            p.image_under(even)
                .expect("a point")
                .distance(motor.apply(p))
                < 1e-12
        );
    }
}

/// Half turns and what is close to them: the case in which quaternions from matrices go wrong.
#[test]
fn half_turns_come_back() {
    let mut random = Random::new(52);
    for _ in 0..10_000 {
        let angle = PI + 10_f64.powf(-8.0 + 8.0 * random.number());
        let rotor = Rotor::about_axis(random.direction(), angle).expect("an axis");
        let matrix = rotor.to_matrix().expect("a rotor");
        let back = Rotor::from_matrix(matrix, 1e-9).expect("a rotation");
        assert!(size(back - rotor).min(size(back + rotor)) < 1e-14);
    }
    let diagonal = |a: f64, b: f64, c: f64| [[a, 0.0, 0.0], [0.0, b, 0.0], [0.0, 0.0, c]];
    for matrix in [
        diagonal(1.0, 1.0, 1.0),
        diagonal(1.0, -1.0, -1.0),
        diagonal(-1.0, 1.0, -1.0),
        diagonal(-1.0, -1.0, 1.0),
    ] {
        let rotor = Rotor::from_matrix(matrix, 0.0).expect("a rotation");
        let again = rotor.to_matrix().expect("a rotor");
        for (a, b) in again.as_flattened().iter().zip(matrix.as_flattened()) {
            assert!((a - b).abs() < 1e-15);
        }
    }
}

#[test]
fn similarities_reflect_and_scale() {
    let mut random = Random::new(53);
    for _ in 0..10_000 {
        let factor = random.number() * 3.0;
        if factor.abs() < 1e-3 {
            continue;
        }
        let mut matrix = random.motor().to_matrix().expect("a motor");
        for row in &mut matrix[..3] {
            for entry in &mut row[..3] {
                *entry *= factor;
            }
        }
        let versor = Even::from_matrix(matrix, 1e-9).expect("a similarity");
        let p = random.point();
        let image = p.image_under(versor).expect("a point");
        assert!(image.distance(transformed(matrix, p)) < 1e-12);
        let again = versor.to_matrix(1e-9).expect("a similarity");
        for (a, b) in again.as_flattened().iter().zip(matrix.as_flattened()) {
            assert!((a - b).abs() < 1e-12);
        }
    }
}

#[test]
fn what_is_no_motion_is_named() {
    let shift = Motor::from(Translator::by(Vector3::new(1.0, 2.0, 3.0)));
    let good = shift.to_matrix().expect("a motor");
    let with = |row: usize, column: usize, value: f64| {
        let mut matrix = good;
        matrix[row][column] = value;
        Motor::from_matrix(matrix, 1e-9)
    };
    assert_eq!(with(0, 0, 1.0), Ok(shift));
    assert_eq!(with(3, 0, 0.5), Err(MatrixError::Projective));
    assert_eq!(with(3, 3, 2.0), Err(MatrixError::Projective));
    assert_eq!(with(0, 1, 0.1), Err(MatrixError::NotSimilar));
    assert_eq!(with(0, 0, 2.0), Err(MatrixError::NotSimilar));
    assert_eq!(with(0, 0, 0.0), Err(MatrixError::NotSimilar));
    assert_eq!(with(1, 1, -1.0), Err(MatrixError::Reflects));
    assert_eq!(with(2, 3, f64::NAN), Err(MatrixError::NotFinite));
    let mut doubled = good;
    for (i, row) in doubled[..3].iter_mut().enumerate() {
        row[i] = 2.0;
    }
    assert_eq!(Motor::from_matrix(doubled, 1e-9), Err(MatrixError::Scales));
    assert_eq!(
        Motor::from_matrix([[0.0; 4]; 4], 1e-9),
        Err(MatrixError::Projective)
    );
    let bend = Even::from(Transversor::by(Vector3::new(1.0, 0.0, 0.0)));
    assert_eq!(bend.to_matrix(1e-9), None);
}

/// A tolerance forgives, and what comes out is a motor nevertheless.
#[test]
fn a_rough_matrix_becomes_a_unit_motor() {
    let mut random = Random::new(54);
    for _ in 0..1000 {
        let motor = random.motor();
        let mut matrix = motor.to_matrix().expect("a motor");
        for row in &mut matrix[..3] {
            for entry in &mut row[..3] {
                *entry += 1e-6 * random.number();
            }
        }
        assert!(Motor::from_matrix(matrix, 1e-9).is_err());
        let back = Motor::from_matrix(matrix, 1e-5).expect("a rigid motion");
        assert!(size(back * back.reverse() - Motor::identity()) < 1e-14);
        assert!(size(back - motor).min(size(back + motor)) < 1e-4);
    }
}
