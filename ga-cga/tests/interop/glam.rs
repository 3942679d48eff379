//! `glam` and the versors move points alike, in both precisions.

use ga_cga::{Point, Rotor, Vector3};
use glam::{DQuat, DVec3, Quat, Vec3};
use proptest::prelude::*;

macro_rules! laws {
    ($($name:ident $number:ident $Vector:ident $Quaternion:ident $tolerance:literal)*) => {$(
        mod $name {
            use super::*;

            fn vector() -> impl Strategy<Value = $Vector> {
                prop::array::uniform3(-10.0..10.0 as $number).prop_map($Vector::from_array)
            }

            fn quaternion() -> impl Strategy<Value = $Quaternion> {
                prop::array::uniform3(-4.0..4.0 as $number)
                    .prop_map(|v| $Quaternion::from_scaled_axis($Vector::from_array(v)))
            }

            proptest! {
                #[test]
                fn rotations_agree(q in quaternion(), v in vector()) {
                    let expected = q * v;
                    let direction = Rotor::from(q).apply(Vector3::from(v));
                    prop_assert!($Vector::from(direction).distance(expected) < $tolerance);
                    let point = Rotor::from(q).apply(Point::from(v));
                    prop_assert!($Vector::from(point).distance(expected) < $tolerance);
                }

                #[test]
                fn compositions_agree(p in quaternion(), q in quaternion()) {
                    let product: Rotor<$number> = Rotor::from(p) * Rotor::from(q);
                    let product = $Quaternion::from(product);
                    prop_assert!((product - p * q).length() < $tolerance);
                    let inverse = $Quaternion::from(Rotor::from(q).reverse());
                    prop_assert_eq!(inverse, q.conjugate());
                }

                #[test]
                fn round_trips(q in quaternion(), v in vector()) {
                    prop_assert_eq!($Quaternion::from(Rotor::from(q)), q);
                    prop_assert_eq!($Vector::from(Vector3::from(v)), v);
                    prop_assert_eq!($Vector::from(Point::from(v)), v);
                    prop_assert_eq!(Point::from(v), Point::at(v.x, v.y, v.z));
                }
            }
        }
    )*};
}

laws! {
    double f64 DVec3 DQuat 1e-12
    single f32 Vec3 Quat 1e-4
}

/// Four coefficients are a vector of four, which is not the quaternion.
#[test]
fn coefficients_are_not_quaternions() {
    let rotor = Rotor::new(1.0, 2.0, 3.0, 4.0);
    assert_eq!(
        glam::DVec4::from(rotor),
        glam::DVec4::new(1.0, 2.0, 3.0, 4.0)
    );
    assert_eq!(DQuat::from(rotor), DQuat::from_xyzw(-4.0, 3.0, -2.0, 1.0));
}

/// Matrices and affine maps of rigid motions, and matrices of similarities, in both precisions.
macro_rules! matrices {
    ($test:ident $number:ident $Matrix:ident $Affine:ident $Vector:ident $Quaternion:ident $tolerance:literal) => {
        #[test]
        fn $test() {
            use ga_cga::{Even, Motor};
            use glam::{$Affine, $Matrix};

            let axis = $Vector::new(0.6, 0.0, 0.8);
            for step in 0..40 {
                let angle = step as $number * 0.16;
                let turn = $Quaternion::from_axis_angle(axis, angle);
                let shift = $Vector::new(1.0, angle, -2.0);
                let x = $Vector::new(0.3, -0.7, 1.1);

                let matrix = $Matrix::from_rotation_translation(turn, shift);
                let motor = Motor::try_from(matrix).expect("a motion");
                let image = $Vector::from(motor.apply(Point::from(x)));
                assert!((image - matrix.transform_point3(x)).length() < $tolerance);
                let back = $Matrix::try_from(motor).expect("a motor");
                assert!(back.abs_diff_eq(matrix, $tolerance));

                let map = $Affine::from_rotation_translation(turn, shift);
                let motor = Motor::try_from(map).expect("a motion");
                let back = $Affine::try_from(motor).expect("a motor");
                assert!(back.abs_diff_eq(map, $tolerance));

                let scale = $Vector::splat(if step % 2 == 0 { 2.5 } else { -0.4 });
                let matrix = $Matrix::from_scale_rotation_translation(scale, turn, shift);
                let versor = Even::try_from(matrix).expect("a similarity");
                let image = Point::from(x).image_under(versor).expect("a point");
                let image = $Vector::from(image);
                assert!((image - matrix.transform_point3(x)).length() < $tolerance);
                let back = $Matrix::try_from(versor).expect("a similarity");
                assert!(back.abs_diff_eq(matrix, $tolerance));
                assert!(Motor::try_from(matrix).is_err());
            }
            assert!(Motor::try_from($Matrix::ZERO).is_err());
            assert!($Matrix::try_from(Motor::<$number>::default()).is_err());
        }
    };
}

matrices!(matrices_in_single_precision f32 Mat4 Affine3A Vec3 Quat 1e-5);
matrices!(matrices_in_double_precision f64 DMat4 DAffine3 DVec3 DQuat 1e-13);
