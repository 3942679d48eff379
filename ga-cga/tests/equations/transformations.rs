//! §2.4.4: exponentials of conformal 2-blades and the rotors they make, (2.62) to (2.65).

use ga_cga::{
    Bivector3, Circle, DualPlane, DualSphere, Even, Multivector, Point, PointPair, Rotor, Scalar,
    Vector3, cga3,
};
use ga_core::Rational;

use super::samples::{Samples, close, each, near, unit};

/// The exponential by its series, of an argument below about 2 in size.
fn series(x: PointPair) -> Multivector {
    let x = Multivector::from(x);
    let mut term = Multivector::from(Scalar::new(1.0));
    let mut sum = term;
    for k in 1..60 {
        term = term * x / f64::from(k);
        sum += term;
    }
    sum
}

/// 2-blades that square to 1, −1 and 0.
pub fn unit_blades(samples: &mut Samples) -> [PointPair; 3] {
    let [a, b, c]: [Point; 3] = std::array::from_fn(|_| Point::from(samples.element::<Vector3>()));
    let real = (a ^ b).normalized().expect("two points");
    let circle: Circle = a ^ b ^ c;
    let imaginary = circle.dual().normalized().expect("a real circle");
    let normal: Vector3 = samples.element();
    let plane = DualPlane::through(a, normal).expect("the normal has a length");
    [real, imaginary, a ^ plane]
}

/// e^{−θB/2} is cosh − sinh B, cos − sin B or 1 − θB/2 as B² is 1, −1 or 0; compared with the
/// series. The tolerance is 1e-13, relative.
#[test]
fn equation_2_62_exponentials_of_two_blades() {
    each(|samples| {
        let [real, imaginary, null] = unit_blades(samples);
        for (blade, square) in [(real, 1.0), (imaginary, -1.0), (null, 0.0)] {
            near((blade * blade).s, square, 1e-13);
        }
        let theta: f64 = samples.number();
        let half = theta / 2.0;
        let number = |value: f64| Even::from(Scalar::new(value));
        let forms = [
            (real, number(half.cosh()) - Even::from(real * half.sinh())),
            (
                imaginary,
                number(half.cos()) - Even::from(imaginary * half.sin()),
            ),
            (null, number(1.0) - Even::from(null * half)),
        ];
        for (blade, form) in forms {
            close((blade * -half).exp(), form, 1e-13);
            close(series(blade * -half), form.into(), 1e-13);
        }
        // The weight of a non-null blade is its norm.
        near((real * theta).norm(), theta.abs(), 1e-13);
        near((imaginary * theta).norm(), theta.abs(), 1e-13);
    });
}

/// v′ = R v R⁻¹ with R = cos θ/2 − sin θ/2 **B** turns by θ, as the quaternion does: compared with the
/// rotation matrix about the normal. The tolerance is 1e-14.
#[test]
fn equation_2_63_rotors_turn_vectors_as_quaternions_do() {
    each(|samples| {
        let axis = samples.element::<Vector3>().normalized().expect("a length");
        let theta: f64 = samples.number();
        let [x, y, z] = axis.to_array();
        let plane = Bivector3::new(z, -y, x);
        let half = theta / 2.0;
        let rotor = Rotor::from(Scalar::new(half.cos())) - Rotor::from(plane * half.sin());
        let v: Vector3 = samples.element();
        let (sin, cos) = theta.sin_cos();
        let rest = 1.0 - cos;
        let matrix = [
            [
                cos + x * x * rest,
                x * y * rest - z * sin,
                x * z * rest + y * sin,
            ],
            [
                y * x * rest + z * sin,
                cos + y * y * rest,
                y * z * rest - x * sin,
            ],
            [
                z * x * rest - y * sin,
                z * y * rest + x * sin,
                cos + z * z * rest,
            ],
        ];
        let expected = matrix.map(|row| {
            let products = row.iter().zip(v.to_array()).map(|(m, v)| m * v);
            products.sum::<f64>()
        });
        close(rotor.apply(v), expected.into(), 1e-14);
        let inverse = rotor.inverse().expect("a rotor");
        let image = Multivector::from(rotor * v * inverse);
        close(image, Vector3::from(expected).into(), 1e-14);
    });
}

/// A vector of the algebra that is not null.
fn invertible(samples: &mut Samples) -> DualSphere<Rational> {
    loop {
        let vector = DualSphere::from([(); 5].map(|()| samples.whole(3)));
        if vector.inverse().is_some() {
            return vector;
        }
    }
}

/// X′ = R X R⁻¹ for every even versor R, of any weight, and every multivector X.
#[test]
fn equation_2_64_rotors_act_on_every_multivector() {
    each(|samples| {
        // Even versors are products of an even number of vectors.
        let [s, t, u, v] = [(); 4].map(|()| invertible(samples));
        let rotor: cga3::Even<Rational> = s * t * (u * v);
        let x = cga3::Multivector::from([(); 32].map(|()| samples.whole(3)));
        let wide = cga3::Multivector::from(rotor);
        let image = wide * x * wide.inverse().expect("no factor is null");
        assert_eq!(rotor.apply(x), image);
        let sphere: cga3::Sphere<Rational> = samples.element();
        let wide_sphere = cga3::Multivector::from(sphere);
        assert_eq!(
            cga3::Multivector::from(rotor.apply(sphere)),
            wide * wide_sphere * wide.inverse().expect("no factor is null")
        );
    });
}

/// X′ = R X R̃: for exponentials the inverse is the reverse. The tolerance is 1e-13.
#[test]
fn equation_2_65_the_inverse_of_an_exponential_is_its_reverse() {
    each(|samples| {
        let generator = samples.element::<PointPair>() * 0.4;
        let rotor: Even = generator.exp();
        let one = Even::from(Scalar::new(1.0));
        close(rotor * rotor.reverse(), one, 1e-13);
        close((-generator).exp(), rotor.reverse(), 1e-13);
        let circle: Circle = samples.element();
        let image: Circle = rotor.apply(circle);
        close(rotor.sandwich(circle), image, 1e-13);
        // Exactly so for translators, whose generators are null.
        let shift: cga3::DirectionVector<Rational> = unit(1);
        let translator = (shift * samples.number::<Rational>()).exp();
        let square = cga3::Multivector::from(translator * translator.reverse());
        assert_eq!(square, cga3::Scalar::new(Rational::from_integer(1)).into());
    });
}
