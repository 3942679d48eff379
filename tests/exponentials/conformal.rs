//! The types of the conformal model: each has the functions that its kind of motion has.

use ga::cga::cga3::*;

#[test]
fn results_have_the_types_of_the_motions() {
    let line = DualLine::new(0.3, -0.2, 0.4, 1.0, 2.0, -0.5);
    let motor: Motor = line.exp();
    let log: DualLine = motor.log().expect("principal");
    assert!(
        log.to_array()
            .into_iter()
            .zip(line.to_array())
            .all(|(a, b)| (a - b).abs() < 1e-14)
    );
    let root: Motor = motor.sqrt().expect("principal");
    assert!(
        (root * root - motor)
            .to_array()
            .into_iter()
            .all(|x: f64| x.abs() < 1e-14)
    );
    let clean: Motor = (motor * 2.0).renormalized().expect("a versor");
    assert!(
        (clean - motor)
            .to_array()
            .into_iter()
            .all(|x: f64| x.abs() < 1e-14)
    );

    let translator: Translator = DirectionVector::new(1.0, 2.0, 3.0).exp();
    let log: DirectionVector = translator.log().expect("always");
    assert_eq!(log, DirectionVector::new(1.0, 2.0, 3.0));
    let root: Translator = translator.sqrt().expect("always");
    assert_eq!(root, DirectionVector::new(0.5, 1.0, 1.5).exp());

    let transversor: Transversor = TangentVector::new(1.0, 2.0, 3.0).exp();
    let log: TangentVector = transversor.log().expect("always");
    assert_eq!(log, TangentVector::new(1.0, 2.0, 3.0));
    assert!(transversor.sqrt().is_some());

    let dilator: Dilator = MinkowskiPlane::new(0.5).exp();
    let log: MinkowskiPlane = dilator.log().expect("a boost");
    assert!((log.noni - 0.5).abs() < 1e-15);
    let clean: Dilator = (dilator * 7.0).renormalized().expect("a versor");
    assert!((clean.noni - dilator.noni).abs() < 1e-15);

    let pair = PointPair::from(line) + PointPair::from(MinkowskiPlane::new(0.2));
    let versor: Even = pair.exp();
    let log: PointPair = versor.log().expect("principal");
    assert!(
        (log - pair)
            .to_array()
            .into_iter()
            .all(|x: f64| x.abs() < 1e-13)
    );
}

/// Large boosts say little about their norm: it is taken to be one.
#[test]
fn large_scalings() {
    for size in [5.0, 10.0, 14.3, 15.0, 17.7, 30.0, 200.0] {
        let dilator: Dilator = MinkowskiPlane::new(size).exp();
        let log: MinkowskiPlane = dilator.log().expect("a boost");
        assert!((log.noni - size).abs() <= 1e-14 * size, "{size}: {log}");
    }
}

/// The ratio of two motors leads from one to the other along a screw.
#[test]
fn ratios() {
    let (from, to): (Motor, Motor) = (
        DualLine::new(0.3, -0.2, 0.4, 1.0, 2.0, -0.5).exp(),
        DualLine::new(-0.6, 0.1, 0.2, 0.0, 3.0, 1.5).exp(),
    );
    let step: DualLine = (to / from).log().expect("principal");
    let end = step.exp() * from;
    assert!(
        (end - to)
            .to_array()
            .into_iter()
            .all(|x: f64| x.abs() < 1e-14)
    );
    let half = (step * 0.5).exp();
    assert!(
        (half * half * from - to)
            .to_array()
            .into_iter()
            .all(|x: f64| x.abs() < 1e-13)
    );
}

/// Far from the origin, and turned by less than the rounding of one.
#[test]
fn small_rotations_and_far_places() {
    for angle in [1e-8, 1e-17, 1e-100] {
        let line = DualLine::new(angle, 0.0, 0.0, 1e6 * angle, -2e6 * angle, angle);
        let log = line.exp().log().expect("principal");
        let worst = (log - line)
            .to_array()
            .into_iter()
            .fold(0.0, |m: f64, x| m.max(f64::abs(x)));
        assert!(worst <= 1e-15 * 2e6 * angle, "{angle:e}: {worst:e}");
        assert!((log.e12 / angle - 1.0).abs() < 1e-15);
    }
    let far = DualLine::new(0.5, 0.0, 0.2, 1e6, -2e6, 3e5);
    let log = far.exp().log().expect("principal");
    let worst = (log - far)
        .to_array()
        .into_iter()
        .fold(0.0, |m: f64, x| m.max(f64::abs(x)));
    assert!(worst <= 1e-13 * 2e6, "{worst:e}");
}
