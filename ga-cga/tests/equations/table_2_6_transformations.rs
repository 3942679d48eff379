//! Table 2.6, the transformations: one test per row, from the rotor to the transversor.

use std::array::from_fn;

use ga_cga::{
    Bivector3, Dilator, DirectionVector, DualLine, DualSphere, Even, MinkowskiPlane, Motor,
    Multivector, Point, PointPair, Rotor, Scalar, TangentVector, Translator, Transversor, Vector3,
};
use ga_core::Rational;

use super::figures::{Direction, infinity, ratio};
use super::samples::{Samples, close, each, unit};

/// Three orthonormal directions, right-handed.
fn frame(samples: &mut Samples) -> [Vector3; 3] {
    let turn: Rotor = samples.element();
    from_fn(|axis| turn.apply(unit::<Vector3>(axis)))
}

/// The position with these coordinates in a frame.
fn place(frame: [Vector3; 3], [x, y, z]: [f64; 3]) -> Vector3 {
    frame[0] * x + frame[1] * y + frame[2] * z
}

/// Where a round or point image has its centre.
fn center(image: DualSphere) -> Vector3 {
    image.center().expect("not infinity").position()
}

/// Rotor R = e^{−θ**B**/2} = cos θ/2 − sin θ/2 **B**, of grades 0 and 2: it turns by θ in the sense of
/// **B**. The tolerance is 1e-14.
#[test]
fn table_2_6_rotor() {
    each(|samples| {
        let frame = frame(samples);
        let [theta, x, y, z]: [f64; 4] = from_fn(|_| samples.number());
        let plane: Bivector3 = frame[0] ^ frame[1];
        let rotor: Rotor = (plane * (-theta / 2.0)).exp();
        let (sin, cos) = (theta / 2.0).sin_cos();
        close(
            rotor,
            Rotor::from(Scalar::new(cos)) - Rotor::from(plane * sin),
            1e-14,
        );
        let (sin, cos) = theta.sin_cos();
        let expected = place(frame, [x * cos - y * sin, x * sin + y * cos, z]);
        let image: Point = rotor.apply(Point::from(place(frame, [x, y, z])));
        close(image.position(), expected, 1e-14);
    });
}

/// Translator T = e^{−**d** n_∞/2} = 1 − ½**d** n_∞, of grades 0 and 2: it moves by **d**, exactly.
#[test]
fn table_2_6_translator() {
    each(|samples| {
        let [d, x]: [Direction; 2] = from_fn(|_| samples.element());
        let generator = DirectionVector::from(d.to_array()) * ratio(-1, 2);
        let translator: Translator<Rational> = generator.exp();
        assert_eq!(DirectionVector::from(translator.to_array()), generator);
        assert_eq!(translator, Translator::by(d));
        assert_eq!(translator.apply(Point::from(x)), Point::from(x + d));
        let again = DirectionVector::from(x.to_array()) * ratio(-1, 2);
        assert_eq!((generator + again).exp(), translator * again.exp());
    });
}

/// Motor M = e^{−θλ/2} with λ = **B** + **d** n_∞, of grades 0, 2 and 4: it turns by θ about the line
/// of λ and moves along it by θ times the part of **d** along it; it is a rotor times a translator.
/// The tolerance is 1e-13.
#[test]
fn table_2_6_motor() {
    each(|samples| {
        let frame = frame(samples);
        let [theta, x, y, z]: [f64; 4] = from_fn(|_| samples.number());
        let [across, beside, pitch]: [f64; 3] = from_fn(|_| samples.number());
        let plane: Bivector3 = frame[0] ^ frame[1];
        let support = place(frame, [across, beside, pitch]);
        let lambda =
            DualLine::from(plane) + DualLine::from(DirectionVector::from(support.to_array()));
        let motor: Motor = (lambda * (-theta / 2.0)).exp();
        // The line of λ passes through the point (−beside, across) of the plane.
        let (u, v) = (x + beside, y - across);
        let (sin, cos) = theta.sin_cos();
        let expected = place(
            frame,
            [
                u * cos - v * sin - beside,
                across + u * sin + v * cos,
                z + theta * pitch,
            ],
        );
        let image: Point = motor.apply(Point::from(place(frame, [x, y, z])));
        close(image.position(), expected, 1e-13);
        // M = R T, the translation first.
        let rotor: Rotor = (plane * (-theta / 2.0)).exp();
        let rest: Motor = rotor.reverse() * motor;
        let translator: Translator = rest.narrow(1e-13).expect("a translator is left");
        close(rotor * translator, motor, 1e-13);
        // A line alone, without pitch, has a motor of grades 0 and 2: cos θ/2 − sin θ/2 λ.
        let flat = place(frame, [across, beside, 0.0]);
        let line = DualLine::from(plane) + DualLine::from(DirectionVector::from(flat.to_array()));
        let (sin, cos) = (theta / 2.0).sin_cos();
        let form = Motor::from(Scalar::new(cos)) - Motor::from(line * sin);
        close((line * (-theta / 2.0)).exp(), form, 1e-13);
    });
}

/// Dilator D = e^{−cE/2} = cosh c/2 − sinh c/2 E, of grades 0 and 2: it scales by e^{−c} about the
/// origin, so "of amount c" is of minus that; with p∧n_∞ for E about p. The tolerance is 1e-13.
#[test]
fn table_2_6_dilator() {
    each(|samples| {
        let c: f64 = samples.number();
        let minkowski: MinkowskiPlane = unit(0);
        let dilator: Dilator = (minkowski * (-c / 2.0)).exp();
        let form = Dilator::new((c / 2.0).cosh(), -(c / 2.0).sinh());
        close(dilator, form, 1e-14);
        let [x, p]: [Vector3; 2] = from_fn(|_| samples.element());
        let image = dilator.apply(DualSphere::from(Point::from(x)));
        close(center(image), x * (-c).exp(), 1e-13);
        let sphere = DualSphere::about(Point::from(x), 2.0);
        let radius = dilator.apply(sphere).radius_squared().expect("a sphere");
        close(
            Scalar::new(radius),
            Scalar::new(2.0 * (-2.0 * c).exp()),
            1e-13,
        );

        let flat: PointPair = Point::from(p) ^ DualSphere::infinity();
        let about: Even = (flat * (-c / 2.0)).exp();
        let half = c / 2.0;
        let form = Even::from(Scalar::new(half.cosh())) - Even::from(flat * half.sinh());
        close(about, form, 1e-13);
        let image = about.apply(DualSphere::from(Point::from(x)));
        close(center(image), p + (x - p) * (-c).exp(), 1e-13);
    });
}

/// **x**/**x**², the inversion in the unit sphere.
fn inverted(x: Direction) -> Direction {
    x * (ratio(1, 1) / x.norm_squared())
}

/// Transversor (boost) C = e^{−θκ/2} = cosh θ/2 − sinh θ/2 κ, of grades 0 and 2: with θ > 0 it flows
/// to the first point of the unit pair κ from the other; about a tangent n_o it is 1 − ½**v** n_o, an inversion, a
/// translation by **v**/2 and the inversion back, exactly. The tolerance of the boost is 1e-12.
#[test]
fn table_2_6_transversor() {
    each(|samples| {
        let [v, x]: [Direction; 2] = from_fn(|_| samples.element());
        let generator = TangentVector::from(v.to_array()) * ratio(-1, 2);
        let transversor: Transversor<Rational> = generator.exp();
        assert_eq!(TangentVector::from(transversor.to_array()), generator);
        let image: DualSphere<Rational> = transversor.apply(DualSphere::from(Point::from(x)));
        let expected = Point::from(inverted(inverted(x) + v * ratio(1, 2)));
        let weight = -(image | infinity()).s;
        assert_eq!(image, DualSphere::from(expected) * weight);

        let [a, b, p]: [Point; 3] = from_fn(|_| Point::from(samples.element::<Vector3>()));
        let theta: f64 = samples.number();
        let pair: PointPair = (a ^ b).normalized().expect("two points");
        let boost: Even = (pair * (-theta / 2.0)).exp();
        let half = theta / 2.0;
        let form = Even::from(Scalar::new(half.cosh())) - Even::from(pair * half.sinh());
        close(boost, form, 1e-12);
        // Both points stay; the ratio of the squared distances to them falls by e^{−2θ}.
        for fixed in [a, b] {
            let image: DualSphere = boost.apply(DualSphere::from(fixed));
            close(center(image), fixed.position(), 1e-12);
        }
        let image: DualSphere = boost.apply(DualSphere::from(p));
        let distances =
            |q: Vector3| (Point::from(q).distance(a) / Point::from(q).distance(b)).powi(2);
        let ratio = distances(center(image)) / distances(p.position());
        let grows = ratio.ln() / theta;
        close(Scalar::new(grows), Scalar::new(-2.0), 1e-13);
        let wide: Multivector = Multivector::from(boost) * Multivector::from(boost.reverse());
        close(wide, Scalar::new(1.0).into(), 1e-12);
    });
}
