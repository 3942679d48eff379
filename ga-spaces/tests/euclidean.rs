//! Rotors of the plane against complex numbers, of space against nalgebra's quaternions.
#![cfg(feature = "euclidean")]

use ga_core::Rational;
use ga_spaces::{euclidean2, euclidean3};
use nalgebra::{Unit, UnitQuaternion, Vector3};
use proptest::prelude::*;

proptest! {
    #[test]
    fn plane_rotors_are_complex_numbers(angle in -6.0..6.0_f64, more in -6.0..6.0_f64, x in [-5.0..5.0, -5.0..5.0]) {
        let (rotor, other) = (euclidean2::Rotor::by_angle(angle), euclidean2::Rotor::by_angle(more));
        let image = (other * rotor).apply(euclidean2::Vector::new(x[0], x[1]));
        let (sin, cos) = f64::sin_cos(angle + more);
        let expected = euclidean2::Vector::new(cos * x[0] - sin * x[1], sin * x[0] + cos * x[1]);
        prop_assert!((image - expected).norm() < 1e-13);
        prop_assert!((rotor.angle() - angle).abs() < 1e-14);
    }

    #[test]
    fn mirrors_compose_exactly(a in [-9_i128..9, -9_i128..9], b in [-9_i128..9, -9_i128..9], x in [-9_i128..9, -9_i128..9]) {
        let exact = |v: [i128; 2]| {
            let [x, y] = v.map(Rational::from_integer);
            euclidean2::Vector::new(x, y)
        };
        prop_assume!(a != [0, 0] && b != [0, 0]);
        let turned = euclidean2::Rotor::between_mirrors(exact(a), exact(b)).apply(exact(x));
        let reflected: euclidean2::Vector<Rational> = exact(a).apply(exact(x));
        let twice: euclidean2::Vector<Rational> = exact(b).apply(reflected);
        prop_assert_eq!(turned, twice);
    }

    #[test]
    fn space_rotors_are_quaternions(
        axis in [-5.0..5.0, -5.0..5.0, -5.0..5.0], angle in -6.0..6.0, x in [-5.0..5.0, -5.0..5.0, -5.0..5.0],
    ) {
        prop_assume!(Vector3::from(axis).norm() > 1e-2);
        let vector = |v: [f64; 3]| euclidean3::Vector::new(v[0], v[1], v[2]);
        let turn = UnitQuaternion::from_axis_angle(&Unit::new_normalize(Vector3::from(axis)), angle);
        let rotor = euclidean3::Rotor::about_axis(vector(axis), angle).expect("an axis");
        let miss = Vector3::from(rotor.apply(vector(x)).to_array()) - turn * Vector3::from(x);
        prop_assert!(miss.norm() < 1e-13);
        let cross = vector(axis).cross(vector(x)).to_array();
        prop_assert!((Vector3::from(cross) - Vector3::from(axis).cross(&Vector3::from(x))).norm() < 1e-13);
        // The shortest rotation takes one to the other and leaves their common normal.
        prop_assume!(Vector3::from(x).norm() > 1e-2);
        let (from, to) = (vector(axis), vector(x));
        let between = euclidean3::Rotor::between(from, to).expect("not opposite");
        let image = between.apply(from) * (to.norm() / from.norm());
        prop_assert!((image - to).norm() < 1e-9);
        let normal = from.cross(to);
        prop_assert!((between.apply(normal) - normal).norm() < 1e-9);
    }
}

/// Close to opposite vectors the rotation is as exact as anywhere else.
#[test]
fn nearly_opposite_vectors_leave_one_plane() {
    use euclidean3::{Rotor, Vector};
    let (a, b) = (Vector::new(0.48, -0.6, 0.64), Vector::new(0.8, 0.0, -0.6));
    for exponent in 1..=14 {
        let to = -a + b * 10_f64.powi(-exponent);
        let rotor = Rotor::between(a, to).expect("not opposite");
        let image = rotor.apply(a);
        assert!((image - to / to.norm()).norm() < 2e-15, "1e-{exponent}");
        // The plane itself is only as good as the difference that makes it.
        let normal = a.cross(b);
        assert!((rotor.apply(normal) - normal).norm() < 4e-15 * 10_f64.powi(exponent));
    }
}

#[test]
fn what_leaves_the_plane_open_is_none() {
    use euclidean3::{Bivector, Rotor, Vector};
    let x = Vector::new(1.0, 0.0, 0.0);
    assert_eq!(Rotor::between(x, -x), None);
    assert_eq!(Rotor::between(x, x * 0.0), None);
    assert_eq!(Rotor::between(x * f64::NAN, x), None);
    assert_eq!(Rotor::about_axis(x * 0.0, 1.0), None);
    assert_eq!(Rotor::turn(Bivector::new(0.0, 0.0, 0.0), 1.0), None);
    assert_eq!(Rotor::between(x, x), Some(Rotor::new(1.0, 0.0, 0.0, 0.0)));
}
