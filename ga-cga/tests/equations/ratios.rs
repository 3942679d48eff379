//! §2.3.6 and §2.3.7: the rotor from one vector to another, (2.36) to (2.38), and the camera
//! without roll, Algorithm 2.1.

use ga_core::Rational;

use super::euclidean::{r3, r4};
use super::samples::{Samples, close, each, near, unit};

/// A vector of unit length.
fn direction(samples: &mut Samples) -> r3::Vector {
    let vector: r3::Vector = samples.element();
    vector.normalized().expect("no component is zero")
}

/// (1 + ba)/√(2(1 + ⟨ab⟩)) for unit vectors (2.38).
fn rotor_between(a: r3::Vector, b: r3::Vector) -> r3::Even {
    let sum = r3::Even::from(r3::Scalar::new(1.0)) + b * a;
    sum / (2.0 * (1.0 + (a * b).s)).abs().sqrt()
}

/// R² = b/a = ba for unit vectors a and b; the tolerance is 1e-14.
#[test]
fn equation_2_36_the_ratio_of_two_vectors_is_the_rotor_squared() {
    each(|samples| {
        let [a, b]: [r3::Vector; 2] = std::array::from_fn(|_| direction(samples));
        let rotor = rotor_between(a, b);
        close(rotor * rotor, b * a, 1e-14);
        close(b / a, b * a, 1e-14);
        // The ratio alone turns twice: a goes beyond b as far as it was before it.
        close((b / a).apply(a), b * (2.0 * (a | b).s) - a, 1e-14);
    });
}

/// R = √(ba), which takes a to b; no root is unique between opposite vectors. The tolerance is
/// 1e-14.
#[test]
fn equation_2_37_the_rotor_is_the_root_of_the_ratio() {
    each(|samples| {
        let [a, b]: [r3::Vector; 2] = std::array::from_fn(|_| direction(samples));
        let root = (b * a).sqrt().expect("not opposite");
        close(root, rotor_between(a, b), 1e-14);
        close(root.apply(a), b, 1e-14);
        let e: r3::Vector = unit(1);
        assert_eq!((e * -e).sqrt(), None);
    });
}

/// R = (1 + ba)/√|2(1 + ⟨ab⟩)| takes a to b in their plane, in any dimension: exact before the
/// division, which the versor product makes twice.
#[test]
fn equation_2_38_rotor_between_vectors() {
    each(|samples| {
        // Mirror images of e₁ are exact unit vectors.
        let e1: r3::Vector<Rational> = unit(0);
        let [a, b]: [r3::Vector<Rational>; 2] =
            std::array::from_fn(|_| samples.element::<r3::Vector<Rational>>().apply(e1));
        let one = r3::Even::from(r3::Scalar::new(Rational::from_integer(1)));
        let rotor = one + b * a;
        assert_eq!(rotor.apply(a), b);
        let normal = (a ^ b).dual();
        assert_eq!(rotor.apply(normal), normal);
        // Its norm is the root of (1 + ab)(1 + ba) = 2(1 + ⟨ab⟩).
        let twice = (one.s + (a * b).s) * Rational::from_integer(2);
        assert_eq!((one + a * b) * rotor, r3::Scalar::new(twice).into());

        let e1: r4::Vector<Rational> = unit(0);
        let [a, b]: [r4::Vector<Rational>; 2] =
            std::array::from_fn(|_| samples.element::<r4::Vector<Rational>>().apply(e1));
        let one = r4::Even::from(r4::Scalar::new(Rational::from_integer(1)));
        assert_eq!(r4::Odd::from((one + b * a).apply(a)), b.into());
        assert_eq!(
            (one + a * b) * (one + b * a),
            one * ((one.s + (a * b).s) * Rational::from_integer(2))
        );

        let [a, b]: [r3::Vector; 2] = std::array::from_fn(|_| direction(samples));
        near(rotor_between(a, b).norm(), 1.0, 1e-14);
        close(rotor_between(a, b).sandwich(a), b, 1e-14);
    });
}

/// Algorithm 2.1: the frame turned to face v, with its y axis as upright as it can be.
fn facing(v: r3::Vector) -> r3::Even {
    let [_, e2, e3]: [r3::Vector; 3] = std::array::from_fn(unit);
    let e12: r3::Bivector = unit(0);
    // Step 1.
    let towards = rotor_between(e3, v);
    // Step 2.
    let (plane, upright) = (towards.apply(e12), towards.apply(e2));
    // Step 3.
    let projected = e2.project(plane).normalized().expect("v is not e₂");
    // Steps 4 and 5.
    rotor_between(upright, projected) * towards
}

/// Algorithm 2.1: the camera's z axis meets the target, its x axis is level and its y axis
/// points up; the tolerance is 1e-14.
#[test]
fn algorithm_2_1_camera_without_roll() {
    let [e1, e2, e3]: [r3::Vector; 3] = std::array::from_fn(unit);
    let mut rolls = 0;
    each(|samples| {
        let v = direction(samples);
        let camera = facing(v);
        let [x, y, z] = [e1, e2, e3].map(|axis| camera.apply(axis));
        close(z, v, 1e-14);
        near((x | e2).s, 0.0, 1e-14);
        assert!((y | e2).s > 0.0);
        // The classical frame: x = up × v, y = v × x.
        let level = (e2 ^ v).dual().normalized().expect("v is not e₂");
        close(x, level, 1e-14);
        close(y, (v ^ level).dual(), 1e-14);
        // The first rotation alone rolls.
        let rolled = rotor_between(e3, v).apply(e1);
        rolls += usize::from((rolled | e2).s.abs() > 0.01);
    });
    assert!(rolls > 12);
}
