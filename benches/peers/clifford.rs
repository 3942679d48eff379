//! The contestants of the crate `clifford`, with the feature of this name; none without it.
//!
//! Its motors are those of points as vectors, which compose by the antiproduct.

use ga_benches::data::Data;
use ga_benches::race::Contestant;

/// A type of numbers, and how others become one of it.
#[cfg(feature = "clifford")]
pub trait Number: clifford::scalar::Float + Into<f64> + 'static {
    /// The number.
    fn of(x: f64) -> Self;
}

/// A type of numbers.
#[cfg(not(feature = "clifford"))]
pub trait Number {}

macro_rules! numbers {
    ($($float:ident)*) => {$(
        #[cfg(feature = "clifford")]
        impl Number for $float {
            fn of(x: f64) -> Self {
                x as $float
            }
        }

        #[cfg(not(feature = "clifford"))]
        impl Number for $float {}
    )*};
}

numbers!(f32 f64);

macro_rules! contestants {
    ($($(#[$doc:meta])* $name:ident)*) => {$(
        $(#[$doc])*
        pub fn $name<T: Number>(data: &Data) -> Option<Contestant> {
            #[cfg(feature = "clifford")]
            return Some(contestants::$name::<T>(data));
            #[cfg(not(feature = "clifford"))]
            none(data)
        }
    )*};
}

contestants! {
    /// Rotors on vectors of R3.
    rotor_on_vector
    /// Rotors times rotors of R3.
    rotor_times_rotor
    /// Motors times motors.
    motor_times_motor
    /// Motors on points.
    motor_on_point
}

/// Without the feature nobody comes.
#[cfg(not(feature = "clifford"))]
fn none(_: &Data) -> Option<Contestant> {
    None
}

#[cfg(feature = "clifford")]
mod contestants {
    use clifford::ops::{Transform, Versor};
    use clifford::specialized::euclidean::dim3::{Rotor, Vector};
    use clifford::specialized::projective::dim3::{Motor, Point};
    use ga_benches::data::{Data, Motion};
    use ga_benches::race::Contestant;

    use super::Number;
    use crate::plane_based::corners;

    const NAME: &str = "clifford";

    /// The rotor of a quaternion, whose bivectors are e12, e13, e23.
    fn rotor<T: Number>(q: &[f64; 4]) -> Rotor<T> {
        let [w, x, y, z] = q.map(T::of);
        Rotor::new(w, -z, y, -x)
    }

    fn vector<T: Number>(x: &[f64; 3]) -> Vector<T> {
        let [x, y, z] = x.map(T::of);
        Vector::new(x, y, z)
    }

    fn point<T: Number>(x: &[f64; 3]) -> Point<T> {
        let [x, y, z] = x.map(T::of);
        Point::from_cartesian(x, y, z)
    }

    /// First the rotation, then the translation.
    fn motor<T: Number>(motion: &Motion) -> Motor<T> {
        let [w, x, y, z] = motion.rotation.map(T::of);
        let [a, b, c] = motion.translation.map(T::of);
        let o = T::of(0.0);
        let rotation = Motor::new_unchecked(o, o, o, -x, o, -y, -z, w);
        Motor::from_translation(a, b, c).compose(&rotation)
    }

    fn coordinates<T: Number>(p: &Point<T>) -> Vec<f64> {
        [p.x(), p.y(), p.z()].map(|x| (x / p.w()).into()).to_vec()
    }

    pub fn rotor_on_vector<T: Number>(data: &Data) -> Contestant {
        Contestant::binary(
            NAME,
            data.rotations[0].iter().map(rotor::<T>).collect(),
            data.vectors[0].iter().map(vector::<T>).collect(),
            |r, x| r.transform(&x),
            |x| [x.x(), x.y(), x.z()].map(Into::into).to_vec(),
        )
    }

    pub fn rotor_times_rotor<T: Number>(data: &Data) -> Contestant {
        Contestant::binary(
            NAME,
            data.rotations[0].iter().map(rotor::<T>).collect(),
            data.rotations[1].iter().map(rotor::<T>).collect(),
            |a, b| a * b,
            |q| [q.s(), -q.rx(), q.ry(), -q.rz()].map(Into::into).to_vec(),
        )
    }

    pub fn motor_times_motor<T: Number>(data: &Data) -> Contestant {
        Contestant::binary(
            NAME,
            data.motions[0].iter().map(motor::<T>).collect(),
            data.motions[1].iter().map(motor::<T>).collect(),
            |a, b| a.compose(&b),
            |m| corners(|x| coordinates(&m.transform(&point(x)))),
        )
    }

    pub fn motor_on_point<T: Number>(data: &Data) -> Contestant {
        Contestant::binary(
            NAME,
            data.motions[0].iter().map(motor::<T>).collect(),
            data.vectors[0].iter().map(point::<T>).collect(),
            |m, p| m.transform(&p),
            coordinates,
        )
    }
}
