//! `nalgebra` and the versors move points alike, in both precisions.

use ga_cga::{Motor, Point, Rotor, Translator, Vector3};
use nalgebra::{Isometry3, Point3, Quaternion, Translation3, Unit, UnitQuaternion};
use proptest::prelude::*;

fn isometry() -> impl Strategy<Value = Isometry3<f64>> {
    let axis_angle = prop::array::uniform3(-4.0..4.0_f64);
    let translation = prop::array::uniform3(-10.0..10.0_f64);
    (axis_angle, translation)
        .prop_map(|(a, t)| Isometry3::new(nalgebra::Vector3::from(t), nalgebra::Vector3::from(a)))
}

fn point() -> impl Strategy<Value = Point3<f64>> {
    prop::array::uniform3(-10.0..10.0_f64).prop_map(Point3::from)
}

fn quarter_about(axis: [f64; 3]) -> UnitQuaternion<f64> {
    let axis = Unit::new_normalize(nalgebra::Vector3::from(axis));
    UnitQuaternion::from_axis_angle(&axis, core::f64::consts::FRAC_PI_2)
}

macro_rules! laws {
    ($($name:ident $number:ident $tolerance:literal)*) => {$(
        mod $name {
            use super::*;

            proptest! {
                #[test]
                fn motions_of_points_agree(i in isometry(), p in point()) {
                    let (i, p): (Isometry3<$number>, Point3<$number>) = (i.cast(), p.cast());
                    let image: Point<$number> = Motor::from(i).apply(Point::from(p));
                    let expected = i * p;
                    prop_assert!((Point3::from(image) - expected).norm() < $tolerance);
                    // The image is a point of weight 1 that lies on the null cone.
                    let cone = Point::from(expected).ni - image.ni;
                    prop_assert!(cone.abs() < 100.0 * $tolerance);
                }

                #[test]
                fn rotations_and_translations_agree(i in isometry(), p in point()) {
                    let (i, p): (Isometry3<$number>, Point3<$number>) = (i.cast(), p.cast());
                    let turned = Rotor::from(i.rotation).apply(Point::from(p));
                    prop_assert!((Point3::from(turned) - i.rotation * p).norm() < $tolerance);
                    let vector = Rotor::from(i.rotation).apply(Vector3::from(p.coords));
                    let vector = nalgebra::Vector3::from(vector);
                    prop_assert!((vector - i.rotation * p.coords).norm() < $tolerance);
                    let shifted = Translator::from(i.translation).apply(Point::from(p));
                    prop_assert!((Point3::from(shifted) - i.translation * p).norm() < $tolerance);
                }

                #[test]
                fn compositions_and_inverses_agree(a in isometry(), b in isometry()) {
                    let (a, b): (Isometry3<$number>, Isometry3<$number>) = (a.cast(), b.cast());
                    let product: Motor<$number> = Motor::from(a) * Motor::from(b);
                    let expected = Motor::from(a * b);
                    // Quaternions of nalgebra keep their sign in products, so motors do too.
                    for (got, want) in product.to_array().into_iter().zip(expected.to_array()) {
                        prop_assert!((got - want).abs() < $tolerance);
                    }
                    let inverse = Isometry3::from(Motor::from(a).reverse()).to_homogeneous();
                    prop_assert!((inverse - a.inverse().to_homogeneous()).norm() < $tolerance);
                    let quotient: Rotor<$number> =
                        Rotor::from(a.rotation) * Rotor::from(b.rotation).reverse();
                    let expected = Rotor::from(a.rotation * b.rotation.inverse());
                    for (got, want) in quotient.to_array().into_iter().zip(expected.to_array()) {
                        prop_assert!((got - want).abs() < $tolerance);
                    }
                }

                #[test]
                fn round_trips(i in isometry(), p in point()) {
                    let (i, p): (Isometry3<$number>, Point3<$number>) = (i.cast(), p.cast());
                    prop_assert_eq!(Point3::from(Point::from(p)), p);
                    let point = Point::from(p);
                    prop_assert_eq!(Point::from(Point3::from(point)), point);
                    let rotor = Rotor::from(i.rotation);
                    let back = UnitQuaternion::from(rotor);
                    prop_assert_eq!(back.coords, i.rotation.coords);
                    prop_assert_eq!(Rotor::from(back), rotor);
                    // Factors of two lose nothing.
                    let translator = Translator::from(i.translation);
                    prop_assert_eq!(Translation3::from(translator), i.translation);
                    let back = Isometry3::from(Motor::from(i));
                    prop_assert_eq!(back.rotation.coords, i.rotation.coords);
                    let difference = back.translation.vector - i.translation.vector;
                    prop_assert!(difference.norm() < $tolerance);
                }
            }
        }
    )*};
}

laws! {
    double f64 1e-12
    single f32 1e-4
}

/// Quarter turns about the axes as the right-hand rule has them, and the rotors e^{−θB/2} they
/// are by definition.
#[test]
fn quarter_turns_have_the_sense_of_their_plane() {
    let half = core::f64::consts::FRAC_1_SQRT_2;
    let cases = [
        (
            [0.0, 0.0, 1.0],
            Rotor::new(half, -half, 0.0, 0.0),
            [1.0, 0.0, 0.0],
            [0.0, 1.0, 0.0],
        ),
        (
            [1.0, 0.0, 0.0],
            Rotor::new(half, 0.0, 0.0, -half),
            [0.0, 1.0, 0.0],
            [0.0, 0.0, 1.0],
        ),
        (
            [0.0, 1.0, 0.0],
            Rotor::new(half, 0.0, half, 0.0),
            [0.0, 0.0, 1.0],
            [1.0, 0.0, 0.0],
        ),
    ];
    for (axis, rotor, from, to) in cases {
        let got = Rotor::from(quarter_about(axis));
        assert!((got - rotor).norm() < 1e-15, "{axis:?}: {got}");
        let image = got.apply(Vector3::from(from));
        assert!(
            (image - Vector3::from(to)).norm() < 1e-15,
            "{axis:?}: {image}"
        );
        let named = Rotor::about_axis(Vector3::from(axis), core::f64::consts::FRAC_PI_2);
        assert!(
            (named.unwrap_or_default() - rotor).norm() < 1e-15,
            "{axis:?}"
        );
    }
}

/// A quaternion and its negative turn alike and stay apart.
#[test]
fn the_sign_of_a_quaternion_is_kept() {
    let q = Quaternion::new(-0.5, 0.5, -0.5, 0.5);
    let rotor = Rotor::from(Unit::new_unchecked(q));
    assert_eq!(rotor, Rotor::new(-0.5, -0.5, -0.5, -0.5));
    assert_eq!(UnitQuaternion::from(rotor).into_inner(), q);
}

/// By hand: half a turn about z is R = −e12 and the translation by e1 is T = 1 − ½ e1 n_∞, so
/// T R = −e12 + ½ e1 n_∞ e12 = −e12 + ½ e2 n_∞.
#[test]
fn a_motor_by_hand() {
    let rotation = UnitQuaternion::from_quaternion(Quaternion::new(0.0, 0.0, 0.0, 1.0));
    let isometry = Isometry3::from_parts(Translation3::new(1.0, 0.0, 0.0), rotation);
    let motor = Motor::from(isometry);
    let expected = Motor {
        e12: -1.0,
        e2ni: 0.5,
        ..Motor::default()
    };
    assert_eq!(motor, expected);
    assert_eq!(Isometry3::from(motor), isometry);
}

#[test]
fn the_identity_is_the_identity() {
    assert_eq!(Motor::from(Isometry3::<f64>::identity()), Motor::identity());
    assert_eq!(
        Isometry3::from(Motor::<f32>::identity()),
        Isometry3::identity()
    );
}

/// Lists of coefficients, for a type of more than four.
#[test]
fn every_type_is_a_column_vector() {
    let motor = Motor::from([1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0]);
    let column = nalgebra::SVector::<f64, 8>::from(motor);
    assert_eq!(column.as_slice(), motor.to_array());
    assert_eq!(Motor::from(column), motor);
    assert_eq!(Motor::from(column * 2.0), motor * 2.0);
}

/// Nothing breaks where numbers end.
#[test]
fn extreme_values_pass_through() {
    for position in [[f64::MAX, 0.0, 0.0], [0.0; 3], [1e-320, -0.0, 1e200]] {
        let p = Point3::from(position);
        let point = Point::from(p);
        assert_eq!(Point3::from(point), p);
        assert!(!point.ni.is_nan());
    }
}
