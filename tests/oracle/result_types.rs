//! Which type a result has: the compiler checks the annotations of these functions.

use ga::cga::cga3::*;

use crate::presets::r3;

/// Fixed coefficients are kept by versors that provably do, and lost by sums and multiples.
#[test]
fn fixed_coefficients() {
    let p = Point::new(1.0, 2.0, 3.0, 7.0);
    let q = Point::new(0.0, 1.0, 0.0, 0.5);
    let motor = Motor::new(0.6, 0.8, 0.0, 0.0, 1.0, 2.0, 0.0, 0.0);
    let rotor = Rotor::new(0.6, 0.8, 0.0, 0.0);
    let translator = Translator::new(0.5, 0.0, 0.0);
    let dilator = Dilator::new(1.25, 0.75);
    let transversor = Transversor::new(0.5, 0.0, 0.0);

    let moved: Point = motor.apply(p);
    let _: DualSphere = motor.sandwich(p);
    let _: Point = rotor.apply(p);
    let shifted: Point = translator.apply(p);
    let _: DualSphere = dilator.apply(p);
    let _: DualSphere = transversor.apply(p);
    let _: DualSphere = p + q;
    let _: DualSphere = p - q;
    let _: DualSphere = -p;
    let _: DualSphere = p * 2.0;
    let _: DualSphere = 2.0 * p;
    let _: DualSphere = [p, q].into_iter().sum();
    let _: Translator = translator * translator;
    let _: Translator = translator.reverse();
    let _: Option<Point> = Point::try_from((p + q) * 0.5).ok();

    assert_eq!(shifted, Point::new(0.0, 2.0, 3.0, 6.5));
    assert!((moved.norm_squared() - p.norm_squared()).abs() < 1e-12);
}

#[test]
fn conformal_products() {
    let p = Point::new(1.0, 2.0, 3.0, 7.0);
    let a = Vector3::new(1.0, 2.0, 3.0);
    let rotor = Rotor::new(0.6, 0.8, 0.0, 0.0);
    let translator = Translator::new(0.5, 0.0, 0.0);
    let motor: Motor = translator * rotor;
    let _: Motor = rotor * translator;
    let _: Motor = motor * motor;
    let _: Rotor = rotor * rotor;
    let _: Rotor = a * a;
    let _: Bivector3 = a ^ a;
    let _: Trivector3 = a ^ a ^ a;
    let pair: PointPair = p ^ p;
    let circle: Circle = pair ^ p;
    let sphere: Sphere = circle ^ p;
    let _: Pseudoscalar = sphere ^ p;
    let _: Scalar = p | p;
    let _: f64 = p.scalar_product(p);
    let _: PointPair = circle.dual();
    let _: DualSphere = !sphere;
    let _: DualLine = Line::new(1.0, 0.0, 0.0, 0.0, 0.0, 0.0).dual();
    let _: DualPlane = Plane::new(1.0, 0.0, 0.0, 0.0).dual();
    let _: Vector3 = rotor.apply(a);
    let _: DualPlane = translator.apply(a);
    let _: Line = motor.apply(Line::new(1.0, 0.0, 0.0, 0.0, 0.0, 0.0));
    let _: Plane = motor.apply(Plane::new(1.0, 0.0, 0.0, 0.0));
    let _: Circle = motor.apply(circle);
    let _: Rotor = Bivector3::new(0.1, 0.2, 0.3).exp();
    let _: Option<Bivector3> = rotor.log();
    let _: Option<Rotor> = rotor.sqrt();
    let _: Dilator = MinkowskiPlane::new(0.1).exp();
}

#[test]
fn preset_products() {
    use r3::{Bivector, Even, Multivector, Odd, Scalar, Trivector, Vector};
    let a = Vector::new(1.0, 2.0, 3.0);
    let even: Even = a * a;
    let area: Bivector = a ^ a;
    let _: Scalar = a | a;
    let _: Odd = area * a;
    let _: Even = even * even;
    let _: Vector = a << area;
    let _: Trivector = a ^ area;
    let _: Scalar = a & area;
    let _: Vector = area & area;
    let _: Even = area.exp();
    let _: Option<Bivector> = even.log();
    let _: Option<Vector> = a.inverse();
    let _: Vector = a.project(area);
    let _: Trivector = area.wedge(a);
    let _: Option<Multivector> = Multivector::from(a).inverse();
    let _: Vector = even.apply(a);
}
