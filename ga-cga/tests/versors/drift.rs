//! Long products drift, and polar normalisation brings them back.

use crate::random::{Random, size};
use ga_cga::{DualSphere, Even, Motor, Rotor, Sphere};

/// A thousand turns in single precision leave the versors, and come back to the right place.
#[test]
fn a_long_product_is_a_unit_versor_again() {
    let mut random = Random::new(31);
    let mut worst: f32 = 0.0;
    for _ in 0..100 {
        let motor = random.motor().map(|c| c as f32);
        let back: Motor<f32> = motor.reverse();
        let start: Motor<f32> = random.motor().map(|c| c as f32);
        let there_and_back =
            (0..1000).fold(
                start,
                |all, i| {
                    if i % 2 == 0 { motor * all } else { back * all }
                },
            );
        let drift = |m: Motor<f32>| size(m * m.reverse() - Motor::identity());
        worst = worst.max(drift(there_and_back));
        let unit = there_and_back.renormalized().expect("close to a versor");
        assert!(drift(unit) < 3e-6);
    }
    assert!(worst > 1e-5, "nothing has drifted: {worst}");
}

/// A versor with noise is brought to one that differs by the noise, not more; a versor stays.
#[test]
fn what_is_close_stays_close() {
    let mut random = Random::new(32);
    for _ in 0..10_000 {
        let motor = random.motor();
        let noise: Motor = random.element();
        let unit = (motor * 3.0 + noise * 1e-6).renormalized().expect("close");
        assert!(size(unit * unit.reverse() - Motor::identity()) < 1e-13);
        assert!(size(unit - motor) < 1e-5);
        assert!(size(motor.renormalized().expect("a versor") - motor) < 1e-14);

        let even = random.even();
        if (even * even.reverse()).s < 0.0 {
            // A real and an imaginary sphere: there is no unit versor nearby.
            continue;
        }
        let versor = even.renormalized().expect("a versor");
        let one = Even::from(Motor::identity());
        let scale = size(versor) * size(versor);
        let off = size(versor * versor.reverse() - one);
        assert!(off < 1e-11 * scale, "{off} for {scale}");
    }
}

#[test]
fn what_is_far_from_every_versor_is_refused() {
    assert_eq!(Motor::<f64>::default().renormalized(), None);
    assert_eq!(Even::<f64>::default().renormalized(), None);
    let null = Even::from(ga_cga::PointPair::from(ga_cga::DirectionVector::new(
        1.0, 0.0, 0.0,
    )));
    assert_eq!(null.renormalized(), None);
    let direct: Sphere = DualSphere::infinity().undual();
    assert_eq!(Even::from(direct).renormalized(), None);
    let huge = Motor::from(Rotor::identity()) * 1e50;
    let unit = huge.renormalized().expect("a heavy identity");
    assert!(size(unit - Motor::identity()) < 1e-15);
    let tiny = Motor::from(Rotor::identity()) * -1e-50;
    let unit = tiny.renormalized().expect("a light identity");
    assert!(size(unit + Motor::identity()) < 1e-15);
}
