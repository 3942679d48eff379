//! §2.4.5: ratios of blades, interpolation and logarithms, (2.66) to (2.70).

use ga_cga::{
    Bivector3, Circle, Dilator, DirectionVector, DualPlane, Even, Line, MinkowskiPlane, Motor,
    Multivector, Point, PointPair, Rotor, Scalar, Translator, Vector3,
};

use super::samples::{Samples, close, each, unit};
use super::transformations::unit_blades;

/// A moderate rigid motion.
fn motion(samples: &mut Samples) -> Motor {
    let plane: Bivector3 = samples.element();
    let rotor = Rotor::turn(plane, 0.7 * samples.number::<f64>()).expect("a plane");
    Motor::rigid(rotor, Translator::by(samples.element()))
}

/// A normalised circle, and its image under a motion and a scaling.
fn circles(samples: &mut Samples) -> [Circle; 2] {
    let [a, b, c]: [Point; 3] = std::array::from_fn(|_| Point::from(samples.element::<Vector3>()));
    let first: Circle = (a ^ b ^ c).normalized().expect("three points");
    let scaling: Dilator = (unit::<MinkowskiPlane>(0) * (0.2 * samples.number::<f64>())).exp();
    let moved: Circle = scaling.apply(motion(samples).apply(first));
    [first, moved.normalized().expect("a circle")]
}

/// R² = (B/A)/‖B/A‖: twice the transformation that takes a blade to another one of its kind,
/// so that √R² takes A to B. The tolerance is 1e-13.
#[test]
fn equation_2_66_the_ratio_of_two_blades() {
    each(|samples| {
        let [first, second] = circles(samples);
        let square = (second / first).normalized().expect("a versor");
        close(square, second / first, 1e-13);
        let root = square.sqrt().expect("no opposite circles");
        close(root.apply(first), second, 1e-13);

        let motor = motion(samples);
        let plane = DualPlane::at_distance(unit(0), samples.number());
        let moved: DualPlane = motor.apply(plane);
        let root = (moved / plane)
            .sqrt()
            .expect("not the same plane turned over");
        close(root.apply(plane), moved, 1e-13);

        let x = Point::from(samples.element::<Vector3>());
        let y = Point::from(samples.element::<Vector3>());
        let line: Line = (x ^ y ^ ga_cga::DualSphere::infinity())
            .narrow(1e-12)
            .expect("a line");
        let line = line.normalized().expect("two points");
        let moved: Line = motor.apply(line);
        let root = (moved / line)
            .sqrt()
            .expect("not the same line turned round");
        close(root.apply(line), moved, 1e-13);
    });
}

/// R_t = e^{t/2 log R²}; the print has −t/2, which is the inverse. The tolerance is 1e-13.
#[test]
fn equation_2_67_interpolation_between_blades() {
    each(|samples| {
        let [first, second] = circles(samples);
        let logarithm = (second / first).log().expect("no opposite circles");
        let at = |t: f64| (logarithm * (t / 2.0)).exp();
        close(at(0.0), Even::from(Scalar::new(1.0)), 1e-15);
        close(at(1.0).apply(first), second, 1e-13);
        close(at(0.3) * at(0.45), at(0.75), 1e-13);
        close(at(0.5).apply(at(0.5).apply(first)), second, 1e-13);
        let printed = (logarithm * -0.5).exp();
        let wrong: Circle = printed.apply(first);
        assert!(
            Multivector::from(wrong - second)
                .to_array()
                .iter()
                .any(|c| c.abs() > 1e-3)
        );
    });
}

/// (2.69): the arc of hyperbolic, null or circular size along s, for a cosine c. Without a
/// logarithm where c < 0 and s² ≥ 0, which the print overlooks.
fn atanh2(sine: PointPair, cosine: f64) -> Option<PointPair> {
    let square = (sine * sine).s;
    if square.abs() < 1e-12 {
        return (cosine > 0.0).then_some(sine);
    }
    let size = square.abs().sqrt();
    if square > 0.0 {
        return (cosine > 0.0).then(|| sine * (size.asinh() / size));
    }
    Some(sine * (size.atan2(cosine) / size))
}

/// The grade 2 of an even element.
fn bivector(x: Even) -> PointPair {
    Multivector::from(x)
        .grade(2)
        .narrow(0.0)
        .expect("only grade 2 is left")
}

/// Simple rotors e^B of all three kinds, with B.
fn simple(samples: &mut Samples) -> [(Even, PointPair); 3] {
    let [real, imaginary, null] = unit_blades(samples);
    let [a, b, c] = [
        real * samples.number::<f64>(),
        imaginary * (1.5 * samples.number::<f64>()),
        null * samples.number::<f64>(),
    ];
    [a, b, c].map(|blade| (blade.exp(), blade))
}

/// log R = atanh2(⟨R⟩₂, ⟨R⟩) for simple rotors. The tolerance is 1e-13.
#[test]
fn equation_2_68_the_logarithm_of_a_simple_rotor() {
    each(|samples| {
        for (rotor, generator) in simple(samples) {
            let formula = atanh2(bivector(rotor), rotor.s).expect("the cosine is positive");
            close(formula, generator, 1e-13);
            close(rotor.log().expect("a principal one"), generator, 1e-13);
            close(formula.exp(), rotor, 1e-13);
        }
    });
}

/// atanh2(s, c) by the sign of s²; for s² ≥ 0 and c < 0, where the print ignores c, there is
/// no real logarithm, and that of −R acts the same. The tolerance is 1e-13.
#[test]
fn equation_2_69_the_arc_of_a_sine_and_a_cosine() {
    each(|samples| {
        // Exactly simple ones: rounding could make a versor that turns by nearly π besides.
        let boost = PointPair::from(unit::<MinkowskiPlane>(0)) * samples.number::<f64>();
        let shift = PointPair::from(samples.element::<DirectionVector>());
        for generator in [boost, shift] {
            let rotor = generator.exp();
            let negative = -rotor;
            assert_eq!(atanh2(bivector(negative), negative.s), None);
            assert_eq!(negative.log(), None);
            // The arc of the print, which ignores c, is −B: its exponential is R̃ and not −R.
            close((-generator).exp(), rotor.reverse(), 1e-13);
            let point = Point::from(samples.element::<Vector3>());
            let image: ga_cga::DualSphere = rotor.sandwich(point);
            close(negative.sandwich(point), image, 1e-13);
        }
        // Any cosine will do for a turn.
        let [_, (turn, imaginary), _] = simple(samples);
        let negative = -turn;
        let formula = atanh2(bivector(negative), negative.s).expect("a turn");
        close(formula.exp(), negative, 1e-13);
        close(negative.log().expect("a turn"), formula, 1e-13);
        assert!(
            (formula ^ imaginary)
                .to_array()
                .iter()
                .all(|c| c.abs() < 1e-13)
        );
    });
}

/// −(π − atan2(√−s², c)) s/√−s² turns the other way round: it is the logarithm of −R. The
/// tolerance is 1e-13.
#[test]
fn equation_2_70_the_rotation_in_the_opposite_direction() {
    each(|samples| {
        let [_, imaginary, _] = unit_blades(samples);
        let angle = 1.4 * samples.number::<f64>().abs();
        let rotor = (imaginary * angle).exp();
        let sine = bivector(rotor);
        let size = (-(sine * sine).s).sqrt();
        let opposite = sine * (-(std::f64::consts::PI - size.atan2(rotor.s)) / size);
        close(opposite, imaginary * (angle - std::f64::consts::PI), 1e-13);
        close(opposite.exp(), -rotor, 1e-13);
        close((-rotor).log().expect("a turn"), opposite, 1e-13);
        let x: Circle = samples.element();
        close(opposite.exp().apply(x), rotor.apply(x), 1e-13);
    });
}
