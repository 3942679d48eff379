//! §2.3.1 to §2.3.5: reflections, projections and rotations, (2.26) to (2.35).

use ga_cga::cga3;
use ga_core::Rational;

use super::euclidean::{r2, r3};
use super::samples::{close, each, unit};

type Vector = r3::Vector<Rational>;
type Bivector = r3::Bivector<Rational>;
type Multivector = r3::Multivector<Rational>;

/// a = a∥ + a⊥, with b∧a∥ = 0 and b·a⊥ = 0.
#[test]
fn equation_2_26_a_vector_is_its_projection_and_its_rejection() {
    each(|samples| {
        let [a, b]: [Vector; 2] = std::array::from_fn(|_| samples.element());
        let (parallel, orthogonal) = (a.project(b), a.reject(b));
        assert_eq!(parallel + orthogonal, a);
        assert_eq!(b ^ parallel, Bivector::default());
        assert_eq!(b | orthogonal, r3::Scalar::default());
    });
}

/// −b a b⁻¹ = −a∥ + a⊥: the reflection in the plane that b is normal to.
#[test]
fn equation_2_27_a_reflection_turns_the_parallel_part_round() {
    each(|samples| {
        let [a, b]: [Vector; 2] = std::array::from_fn(|_| samples.element());
        // The parts by the dot product alone.
        let parallel = b * ((a | b).s / (b | b).s);
        let image = a - parallel - parallel;
        assert_eq!(
            -(b * a * b.inverse().expect("no component of b is zero")),
            r3::Odd::from(image)
        );
        assert_eq!(b.apply(a), image);
    });
}

/// A ↦ X Â X⁻¹: the involution makes every odd versor preserve outer products, sign included.
#[test]
fn equation_2_28_versors_act_on_multivectors_through_the_involution() {
    each(|samples| {
        let a: Multivector = samples.element();
        let [u, v, w]: [Vector; 3] = std::array::from_fn(|_| samples.element());
        let versor = Multivector::from(u * v * w);
        let image = versor * a.involute() * versor.inverse().expect("a versor");
        assert_eq!(Multivector::from((u * v * w).apply(a)), image);
        assert_eq!(u.apply(v ^ w), u.apply(v) ^ u.apply(w));
        assert_eq!((u * v).apply(v ^ w), (u * v).apply(v) ^ (u * v).apply(w));
        // The same in the conformal model: an inversion of a circle.
        let sphere: cga3::DualSphere<Rational> = samples.element();
        let circle: cga3::Circle<Rational> = samples.element();
        let wide = cga3::Multivector::from(circle).involute();
        let inverse = sphere.inverse().expect("no null vector");
        assert_eq!(
            cga3::Multivector::from(sphere.apply(circle)),
            cga3::Multivector::from(sphere) * wide * inverse
        );
    });
}

/// (a·B)B⁻¹ is the vector in the plane of B below a.
#[test]
fn equation_2_29_the_projection_on_a_plane() {
    each(|samples| {
        let [u, v, n]: [Vector; 3] = std::array::from_fn(|_| samples.element());
        let plane = u ^ v;
        // n without its parts along an orthogonal basis u, v⊥ of the plane.
        let w = v - u * ((u | v).s / (u | u).s);
        let below = u * ((n | u).s / (u | u).s) + w * ((n | w).s / (w | w).s);
        let inverse = plane.inverse().expect("u and v are independent");
        assert_eq!((n | plane) * inverse, below.into());
        assert_eq!(n.project(plane), below);
        assert_eq!(below ^ plane, r3::Trivector::default());
    });
}

/// (a∧B)B⁻¹ is the rest, orthogonal to B.
#[test]
fn equation_2_30_the_rejection_from_a_plane() {
    each(|samples| {
        let [u, v, n]: [Vector; 3] = std::array::from_fn(|_| samples.element());
        let plane = u ^ v;
        let above = n.reject(plane);
        let inverse = plane.inverse().expect("u and v are independent");
        assert_eq!(Multivector::from((n ^ plane) * inverse), above.into());
        assert_eq!(above | u, r3::Scalar::default());
        assert_eq!(above | v, r3::Scalar::default());
        assert_eq!(above + n.project(plane), n);
    });
}

/// a ↦ R a R̃ with R = cb of unit vectors: the reflection in b and then in c, a rotation in
/// their plane by twice the angle from b to c.
#[test]
fn equation_2_31_two_reflections_are_a_rotation_by_twice_the_angle() {
    each(|samples| {
        // Mirror images of e₁ are exact unit vectors.
        let e1: Vector = unit(0);
        let [b, c]: [Vector; 2] = std::array::from_fn(|_| samples.element::<Vector>().apply(e1));
        let one = Rational::from_integer(1);
        let rotor = c * b;
        assert_eq!(rotor * rotor.reverse(), r3::Scalar::new(one).into());
        let a: Vector = samples.element();
        let image: Vector = rotor.sandwich(a);
        assert_eq!(r3::Odd::from(image), rotor * a * rotor.reverse());
        assert_eq!(r3::Odd::from(image), c * b * a * b * c);
        assert_eq!(image, c.apply(b.apply(a)));
        // b goes to its mirror image behind c: the angle from b to c, twice, in that sense.
        let cosine = (b | c).s;
        assert_eq!(rotor.sandwich(b), c * (cosine + cosine) - b);
        // What is normal to the plane stays.
        let normal = (b ^ c).dual();
        assert_eq!(rotor.sandwich(normal), normal);
    });
}

/// e^{iθ} = cos θ + i sin θ, where i is e₁₂: even elements of the plane are the complex
/// numbers. The tolerance is 1e-15.
#[test]
fn equation_2_32_the_formula_of_euler() {
    let i: r2::Bivector = unit(0);
    assert_eq!(i * i, r2::Scalar::new(-1.0));
    each(|samples| {
        let theta: f64 = 4.0 * samples.number::<f64>();
        close(
            (i * theta).exp(),
            r2::Even::new(theta.cos(), theta.sin()),
            1e-15,
        );
        let [z, w]: [r2::Even<Rational>; 2] = std::array::from_fn(|_| samples.element());
        let ([a, b], [c, d]) = (z.to_array(), w.to_array());
        assert_eq!(z * w, r2::Even::new(a * c - b * d, a * d + b * c));
    });
}

/// An orthonormal frame: the plane u∧v and its normal.
fn frame(samples: &mut super::samples::Samples) -> [r3::Vector; 3] {
    let turn: r3::Even = samples.element();
    std::array::from_fn(|position| turn.apply(unit::<r3::Vector>(position)))
}

/// e^{Bθ} = cos θ + B sin θ for a unit 2-blade B; the tolerance is 1e-14.
#[test]
fn equation_2_33_the_exponential_of_a_unit_plane() {
    each(|samples| {
        let [u, v, _] = frame(samples);
        let theta: f64 = 4.0 * samples.number::<f64>();
        let plane = u ^ v;
        let expected =
            r3::Even::from(r3::Scalar::new(theta.cos())) + r3::Even::from(plane * theta.sin());
        close((plane * theta).exp(), expected, 1e-14);
    });
}

/// The vector with these coordinates in a frame, and its image under a turn from the first
/// axis to the second.
fn turned(frame: [r3::Vector; 3], [x, y, z]: [f64; 3], angle: f64) -> [r3::Vector; 2] {
    let place = |x: f64, y: f64| frame[0] * x + frame[1] * y + frame[2] * z;
    let (sin, cos) = angle.sin_cos();
    [place(x, y), place(x * cos - y * sin, x * sin + y * cos)]
}

/// v ↦ e^{Bθ} v e^{−Bθ} turns by 2θ against the orientation of B; the tolerance is 1e-14.
#[test]
fn equation_2_34_the_exponential_turns_by_minus_twice_the_angle() {
    each(|samples| {
        let frame = frame(samples);
        let [theta, x, y, z]: [f64; 4] = std::array::from_fn(|_| samples.number());
        let plane = frame[0] ^ frame[1];
        let [v, expected] = turned(frame, [x, y, z], -2.0 * theta);
        let image = (plane * theta).exp() * v * (plane * -theta).exp();
        close(image, expected.into(), 1e-14);
        close((plane * theta).exp().apply(v), expected, 1e-14);
    });
}

/// v ↦ e^{−θB/2} v e^{θB/2} turns by θ in the plane of B, in its sense; the tolerance is 1e-14.
#[test]
fn equation_2_35_half_the_angle_in_the_exponent_turns_by_the_angle() {
    each(|samples| {
        let frame = frame(samples);
        let [theta, x, y, z]: [f64; 4] = std::array::from_fn(|_| samples.number());
        let plane = frame[0] ^ frame[1];
        let [v, expected] = turned(frame, [x, y, z], theta);
        let image = (plane * (-theta / 2.0)).exp() * v * (plane * (theta / 2.0)).exp();
        close(image, expected.into(), 1e-14);
        close((plane * (-theta / 2.0)).exp().apply(v), expected, 1e-14);
    });
}
