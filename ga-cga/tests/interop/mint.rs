//! `mint` carries points and rotations unchanged.

use ga_cga::{Point, Rotor, Vector3};
use mint::{Point3, Quaternion};
use proptest::prelude::*;

proptest! {
    #[test]
    fn round_trips(p in prop::array::uniform3(-10.0..10.0_f64), q in prop::array::uniform4(-1.0..1.0_f32)) {
        let point = Point::from(Point3::from(p));
        prop_assert_eq!(point, Point::at(p[0], p[1], p[2]));
        prop_assert_eq!(<[f64; 3]>::from(Point3::from(point)), p);
        let vector = Vector3::from(mint::Vector3::from(p));
        prop_assert_eq!(vector, Vector3::from(p));
        prop_assert_eq!(<[f64; 3]>::from(mint::Vector3::from(vector)), p);
        let rotor = Rotor::from(Quaternion::from(q));
        prop_assert_eq!(<[f32; 4]>::from(Quaternion::from(rotor)), q);
    }
}

/// The product of quaternions i j = k is that of their rotors.
#[test]
fn quaternions_multiply_alike() {
    let unit = |x, y, z| Rotor::from(Quaternion::from([x, y, z, 0.0]));
    let (i, j, k) = (
        unit(1.0, 0.0, 0.0),
        unit(0.0, 1.0, 0.0),
        unit(0.0, 0.0, 1.0),
    );
    let minus_one = Rotor::new(-1.0, 0.0, 0.0, 0.0);
    assert_eq!(i * j, k);
    assert_eq!(j * k, i);
    assert_eq!(k * i, j);
    assert_eq!(i * i, minus_one);
    assert_eq!(i * j * k, minus_one);
}

/// Generic code finds the type by itself.
#[test]
fn elements_know_their_type() {
    fn length_squared<V: mint::IntoMint<MintType = mint::Vector3<f64>>>(v: V) -> f64
    where
        mint::Vector3<f64>: From<V>,
    {
        let [x, y, z] = mint::Vector3::from(v).into();
        x * x + y * y + z * z
    }
    assert_eq!(length_squared(Vector3::new(1.0, 2.0, 2.0)), 9.0);
}
