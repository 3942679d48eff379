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
