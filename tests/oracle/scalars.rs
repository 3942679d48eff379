//! The same generated code over integers, single precision, lanes and dual numbers.

use ga::cga::cga3;
use ga::core::Dual;
use ga::core::ops::Element;

use crate::presets::r3;
use crate::samples::Samples;
use crate::six_dimensions::{r3_3, r6};

/// Products need a ring only, also those that loop.
#[test]
fn integers() {
    let a = r3::Vector::new(1_i64, 2, 3);
    let b = r3::Vector::new(4, 5, 6);
    assert_eq!(a * b, r3::Even::new(32, -3, -6, -3));
    assert_eq!((a ^ b) * 2, r3::Bivector::new(-6, -12, -6));
    assert_eq!(a.commutator(b), a ^ b);
    assert_eq!(a.sandwich(b), r3::Vector::new(-8, -58, -108));
    assert_eq!(a.norm_squared(), 14);
    let even = |factor: i64| r6::Even::from_fn(|i| factor * (i as i64 % 5 - 2));
    let exact = |factor: f64| r6::Even::from_fn(|i| factor * (i as f64 % 5.0 - 2.0));
    let product = even(1).geometric(even(3));
    assert_eq!(product.map(|x| x as f64), exact(1.0).geometric(exact(3.0)));
    let bivector = r3_3::Bivector::from_fn(|i| i as i64);
    let square = bivector.geometric(r3_3::Even::from(bivector));
    assert_eq!(square, r3_3::Even::from(bivector).geometric(bivector));
}

fn motor(samples: &mut Samples) -> cga3::Motor {
    let part = cga3::DualLine::from_fn(|_| samples.float());
    let rotor = cga3::Bivector3::new(part.e12, part.e13, part.e23).exp();
    let translator = cga3::Translator::new(part.e1ni, part.e2ni, part.e3ni);
    translator * rotor
}

#[test]
fn single_precision() {
    let mut samples = Samples::new(61);
    for _ in 0..20 {
        let (m, p) = (
            motor(&mut samples),
            cga3::Point::from_fn(|_| samples.float()),
        );
        let image = m.apply(p).to_array();
        let single = m.map(|x| x as f32).apply(p.map(|x| x as f32)).to_array();
        for (double, single) in image.into_iter().zip(single) {
            assert!(
                (double - f64::from(single)).abs() < 2e-5,
                "{double} {single}"
            );
        }
    }
}

#[test]
fn lanes_compute_what_each_lane_would() {
    use wide::{f32x8, f64x4};
    let mut samples = Samples::new(67);
    let motors: [cga3::Motor; 4] = std::array::from_fn(|_| motor(&mut samples));
    let points: [cga3::Point; 4] =
        std::array::from_fn(|_| cga3::Point::from_fn(|_| samples.float()));
    let wide_motor = cga3::Motor::from_fn(|i| f64x4::new(motors.map(|m| m.at(i))));
    let wide_point = cga3::Point::from_fn(|i| f64x4::new(points.map(|p| p.at(i))));
    let image = wide_motor.apply(wide_point);
    let product = wide_motor.geometric(wide_point);
    for lane in 0..4 {
        let close = |wide: f64x4, single: f64| (wide.to_array()[lane] - single).abs() < 1e-13;
        let alone = motors[lane].apply(points[lane]);
        assert!((0..4).all(|i| close(image.at(i), alone.at(i))));
        let alone = motors[lane].geometric(points[lane]);
        assert!((0..16).all(|i| close(product.at(i), alone.at(i))));
    }
    let angles: [f32; 8] = std::array::from_fn(|i| i as f32 * 0.4);
    let zero = f32x8::new([0.0; 8]);
    let rotor = cga3::Bivector3::new(f32x8::new(angles), zero, zero).exp();
    let roots = rotor.sqrt().expect("angles below π");
    for (lane, angle) in angles.into_iter().enumerate() {
        assert!((rotor.s.to_array()[lane] - angle.cos()).abs() < 1e-6);
        assert!((roots.e12.to_array()[lane] - (angle / 2.0).sin()).abs() < 1e-6);
    }
}

/// The derivative of a turned vector by the angle is the turned vector a quarter turn on.
#[test]
fn dual_numbers_differentiate_a_rotation() {
    for angle in [0.0, 1e-9, 0.7, 3.1, -2.0] {
        let half = Dual::variable(angle) * Dual::constant(-0.5);
        let zero = Dual::constant(0.0);
        let rotor = r3::Bivector::new(half, zero, zero).exp();
        let e1 = r3::Vector::new(Dual::constant(1.0), zero, zero);
        let image = rotor.apply(e1);
        let (sin, cos) = f64::sin_cos(angle);
        let close = |x: Dual<f64>, re: f64, eps: f64| {
            assert!(
                (x.re - re).abs() < 1e-15 && (x.eps - eps).abs() < 4e-15,
                "{x:?} {angle}"
            );
        };
        close(image.e1, cos, -sin);
        close(image.e2, sin, cos);
        close(image.e3, 0.0, 0.0);
    }
}
