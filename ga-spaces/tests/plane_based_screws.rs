//! Exponentials and logarithms of motors of space where their bodies change ways: at the identity,
//! quarters and whole turns, behind a third of a turn, near overflow, and beyond numbers.
#![cfg(feature = "plane-based")]

use core::f64::consts::{FRAC_PI_2, PI};

use ga_core::Unit;
use ga_spaces::plane_based3::{Line, Motor};

/// The exponential of a screw about the third axis, by sine and cosine alone.
fn screw_by_sines(angle: f64, along: f64) -> [f64; 8] {
    // e^{(θ + d e₀₁₂₃…) e₁₂} = (cos θ + e₁₂ sin θ)(1 + d e₀₃).
    let (sin, cos) = angle.sin_cos();
    [cos, 0.0, 0.0, sin, 0.0, 0.0, along * cos, along * sin]
}

/// In the order scalar, e23, e31, e12, e01, e02, e03, e0123.
fn coefficients(motor: Motor) -> [f64; 8] {
    motor.to_array()
}

const ANGLES: [f64; 16] = [
    0.0,
    1e-300,
    1e-9,
    0.3,
    1.0,
    FRAC_PI_2 - 1e-12,
    FRAC_PI_2,
    FRAC_PI_2 + 1e-12,
    2.0 * PI / 3.0 - 1e-12,
    2.0 * PI / 3.0 + 1e-12,
    2.5,
    3.0,
    PI - 1e-5,
    PI,
    3.2,
    40.0,
];

#[test]
fn exponentials_are_sines_and_cosines() {
    for angle in ANGLES {
        for along in [0.0, 1e-200, 0.7, 1e5, 1e150] {
            let line = Line::new(0.0, 0.0, angle, 0.0, 0.0, along);
            let found = coefficients(Motor::screw(line));
            let expected = screw_by_sines(angle, along);
            for (found, expected) in found.into_iter().zip(expected) {
                let bound = 2e-15 * (1.0 + angle) * (1.0 + along);
                assert!(
                    (found - expected).abs() <= bound,
                    "{angle} {along}: {found}"
                );
            }
        }
    }
}

#[test]
fn logarithms_lead_back() {
    for angle in ANGLES.into_iter().filter(|angle| *angle < PI) {
        for along in [0.0, 1e-200, 0.7, 1e5, 1e150, 1e160, 1e300] {
            let versor = Motor::from(screw_by_sines(angle, along));
            for log in [Unit::promised(versor).log(), versor.log()] {
                let Some(log) = log else {
                    // What squares beyond all numbers is not known to be a unit versor.
                    assert!(along > 1e150, "{angle} {along}");
                    continue;
                };
                let near = 1.0 / (PI - angle).min(1.0);
                assert!((log.e12 - angle).abs() <= 4e-15 * near, "{angle}: {log}");
                let bound = 1e-14 * near * near * along;
                assert!((log.e03 - along).abs() <= bound, "{angle} {along}: {log}");
                assert!(
                    [log.e23, log.e31, log.e01, log.e02]
                        .iter()
                        .all(|x| *x == 0.0)
                );
            }
        }
    }
}

#[test]
fn what_is_no_motor_has_no_logarithm() {
    let promised = |coefficients: [f64; 8]| Unit::promised(Motor::from(coefficients)).log();
    assert!(promised([-1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]).is_none());
    assert!(promised([0.0; 8]).is_none());
    for place in 0..8 {
        for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            let mut coefficients = screw_by_sines(0.4, 0.2);
            coefficients[place] = value;
            assert!(promised(coefficients).is_none(), "{place} {value}");
            assert!(Motor::from(coefficients).log().is_none());
        }
    }
    // The factor is above 1: what is finite need not stay so.
    let mut coefficients = screw_by_sines(1.5, 0.0);
    coefficients[4] = f64::MAX;
    assert!(promised(coefficients).is_none());
}
