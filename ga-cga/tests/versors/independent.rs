//! An independent library finds the same motions, matrices and similarities.

use crate::random::{Random, size};
use ga_cga::interop::MatrixError;
use ga_cga::{Even, Motor, Point, Rotor, Transversor, Vector3};
use nalgebra::{Isometry3, Matrix3, Matrix4, Point3, Similarity3, UnitDualQuaternion};

fn isometry(random: &mut Random) -> Isometry3<f64> {
    let shift = random.vector() * 4.0;
    let turn = random.vector() * 3.0;
    Isometry3::new(shift.to_array().into(), turn.to_array().into())
}

fn apart(p: Point, q: Point3<f64>) -> f64 {
    (Point3::from(p) - q).norm()
}

#[test]
fn matrices_agree() {
    let mut random = Random::new(61);
    for _ in 0..20_000 {
        let given = isometry(&mut random);
        let motor = Motor::from(given);
        let matrix = Matrix4::try_from(motor).expect("a motor");
        assert!((matrix - given.to_homogeneous()).norm() < 1e-12);
        let back = Motor::try_from(given.to_homogeneous()).expect("a motion");
        assert!(size(back - motor).min(size(back + motor)) < 1e-12);
        let rotation: Matrix3<f64> = given.rotation.to_rotation_matrix().into_inner();
        let rotor = Rotor::try_from(rotation).expect("a rotation");
        let expected = Rotor::from(given.rotation);
        assert!(size(rotor - expected).min(size(rotor + expected)) < 1e-12);
    }
}

#[test]
fn dual_quaternions_agree() {
    let mut random = Random::new(62);
    for _ in 0..20_000 {
        let (a, b) = (isometry(&mut random), isometry(&mut random));
        let quaternion = UnitDualQuaternion::from_isometry(&a);
        let motor = Motor::from(quaternion);
        assert!(size(motor - Motor::from(a)) < 1e-12);
        assert_eq!(UnitDualQuaternion::from(motor), quaternion);
        // They multiply alike.
        let product = quaternion * UnitDualQuaternion::from_isometry(&b);
        let motors = motor * Motor::from(b);
        assert!(size(Motor::from(product) - motors) < 1e-12);
        let p = random.point();
        let moved = quaternion.transform_point(&Point3::from(p));
        assert!(apart(motor.apply(p), moved) < 1e-12);
    }
}

#[test]
fn similarities_agree() {
    let mut random = Random::new(63);
    for _ in 0..20_000 {
        let scale = random.number() * 3.0;
        if scale.abs() < 1e-2 {
            continue;
        }
        let given = Similarity3::from_isometry(isometry(&mut random), scale);
        let versor = Even::try_from(given).expect("it scales");
        let p = random.point();
        let image = p.image_under(versor).expect("a point");
        assert!(apart(image, given * Point3::from(p)) < 1e-12);
        let back = Similarity3::try_from(versor).expect("a similarity");
        assert!((back.to_homogeneous() - given.to_homogeneous()).norm() < 1e-12);
        let matrix = Matrix4::try_from(versor).expect("a similarity");
        assert!((matrix - given.to_homogeneous()).norm() < 1e-12);
        let from_matrix = Even::try_from(given.to_homogeneous()).expect("a similarity");
        let image = p.image_under(from_matrix).expect("a point");
        assert!(apart(image, given * Point3::from(p)) < 1e-12);
    }
    let bend = Even::from(Transversor::by(Vector3::new(0.0, 1.0, 0.0)));
    assert_eq!(Matrix4::try_from(bend), Err(MatrixError::NoMatrix));
    assert!(Similarity3::try_from(bend).is_err());
}

/// The rotor between two vectors is the one that the other library finds.
#[test]
fn rotations_between_vectors_agree() {
    let mut random = Random::new(64);
    for _ in 0..20_000 {
        let (a, b) = (random.vector(), random.vector());
        let expected = nalgebra::UnitQuaternion::rotation_between(
            &nalgebra::Vector3::from(a),
            &nalgebra::Vector3::from(b),
        );
        let (Some(rotor), Some(expected)) = (Rotor::between(a, b), expected) else {
            panic!("{a} and {b} are not opposite")
        };
        let expected = Rotor::from(expected);
        assert!(size(rotor - expected).min(size(rotor + expected)) < 1e-10);
    }
}
