//! §2.2.5 and §2.2.6: duals, involutions, norms and the meet, (2.16) to (2.25).

use ga_cga::cga3;
use ga_core::Rational;

use super::euclidean::{r1_1_1, r2, r3};
use super::samples::{each, near, unit};

type Vector = r3::Vector<Rational>;
type Bivector = r3::Bivector<Rational>;
type Trivector = r3::Trivector<Rational>;
type Multivector = r3::Multivector<Rational>;

fn pseudoscalar() -> Trivector {
    unit(0)
}

/// I = e₁∧…∧e_n.
#[test]
fn equation_2_16_the_pseudoscalar_is_the_outer_product_of_the_basis() {
    let [a, b]: [r2::Vector<Rational>; 2] = std::array::from_fn(unit);
    assert_eq!(a ^ b, unit::<r2::Bivector<Rational>>(0));
    let [a, b, c]: [Vector; 3] = std::array::from_fn(unit);
    assert_eq!(a ^ b ^ c, pseudoscalar());
    // In the conformal model I = e₁∧e₂∧e₃∧n_o∧n_∞, the blade e₁₂₃ E of Table 2.5.
    let [a, b, c, o, i]: [cga3::DualSphere<Rational>; 5] = basis_of_the_conformal_model();
    assert_eq!(a ^ b ^ c ^ o ^ i, unit::<cga3::Pseudoscalar<Rational>>(0));
    let volume: cga3::Trivector3<Rational> = unit(0);
    let minkowski: cga3::MinkowskiPlane<Rational> = unit(0);
    assert_eq!(volume * minkowski, unit::<cga3::Pseudoscalar<Rational>>(0));
}

/// e₁, e₂, e₃, n_o, n_∞.
fn basis_of_the_conformal_model() -> [cga3::DualSphere<Rational>; 5] {
    let mut basis = [cga3::DualSphere::default(); 5];
    let one = Rational::from_integer(1);
    basis[0].e1 = one;
    basis[1].e2 = one;
    basis[2].e3 = one;
    basis[3].no = one;
    basis[4].ni = one;
    basis
}

/// A* = A I⁻¹, of grade n − k.
#[test]
fn equation_2_17_the_dual_divides_by_the_pseudoscalar() {
    let inverse = pseudoscalar().inverse().expect("I is invertible");
    each(|samples| {
        let x: Multivector = samples.element();
        assert_eq!(x.dual(), x * inverse);
        let v: Vector = samples.element();
        let dual: Bivector = v.dual();
        assert_eq!(dual, v * inverse);
        assert_eq!(!v, dual);
        let plane: Bivector = samples.element();
        let normal: Vector = plane.dual();
        assert_eq!(normal, plane * inverse);
        // A conformal pseudoscalar has another square, so another inverse.
        let volume: cga3::Pseudoscalar<Rational> = unit(0);
        let x: cga3::Multivector<Rational> = samples.element();
        assert_eq!(x.dual(), x * volume.inverse().expect("I is invertible"));
    });
}

/// A⁻¹ = Ã/(A Ã), for blades and for every other versor.
#[test]
fn equation_2_18_the_inverse_is_the_reverse_normalised() {
    each(|samples| {
        let [a, b, c]: [Vector; 3] = std::array::from_fn(|_| samples.element());
        let one = Multivector::from(r3::Scalar::new(Rational::from_integer(1)));
        let blade = a ^ b;
        let norm = (blade * blade.reverse()).s;
        assert_eq!(
            r3::Even::from(blade) * blade.reverse(),
            r3::Scalar::new(norm).into()
        );
        assert_eq!(blade.inverse(), Some(blade.reverse() / norm));
        let versor = Multivector::from(a * b * c);
        let norm = a.norm_squared() * b.norm_squared() * c.norm_squared();
        assert_eq!(versor.inverse(), Some(versor.reverse() / norm));
        assert_eq!(versor * (versor.reverse() / norm), one);
        assert_eq!((versor.reverse() / norm) * versor, one);
    });
    let null: r1_1_1::Vector<Rational> = unit(2);
    assert_eq!(null.inverse(), None);
}

/// The reverse of e₁₂₃ is e₃₂₁ = −e₁₂₃.
#[test]
fn equation_2_19_the_reverse_reverses_the_subscripts() {
    let [e1, e2, e3]: [Vector; 3] = std::array::from_fn(unit);
    let volume = pseudoscalar();
    assert_eq!(volume.reverse(), e3 ^ e2 ^ e1);
    assert_eq!(e3 ^ e2 ^ e1, -(e3 ^ e1 ^ e2));
    assert_eq!(-(e3 ^ e1 ^ e2), e1 ^ e3 ^ e2);
    assert_eq!(e1 ^ e3 ^ e2, -volume);
    each(|samples| {
        let [x, y]: [Multivector; 2] = std::array::from_fn(|_| samples.element());
        assert_eq!((x * y).reverse(), y.reverse() * x.reverse());
    });
}

/// A⁻* = A I, so that (A⁻*)* = A.
#[test]
fn equation_2_20_undualising_undoes_the_dual() {
    each(|samples| {
        let x: Multivector = samples.element();
        assert_eq!(x.undual(), x * pseudoscalar());
        assert_eq!(x.undual().dual(), x);
        assert_eq!(x.dual().undual(), x);
        let x: cga3::Multivector<Rational> = samples.element();
        assert_eq!(x.undual(), x * unit::<cga3::Pseudoscalar<Rational>>(0));
        assert_eq!(x.undual().dual(), x);
        assert_eq!(x.dual().undual(), x);
    });
}

/// ‖X‖ = √|⟨X X̃⟩|, with the sign of ⟨X X̃⟩ kept in the squared norm: the print branches on the
/// sign of X², and makes a scalar's norm 0 by (2.71). The tolerance is 1e-15.
#[test]
fn equation_2_21_the_norm_is_that_of_the_reverse() {
    each(|samples| {
        let x: Multivector = samples.element();
        assert_eq!(x.norm_squared(), (x * x.reverse()).s);
        let x: cga3::Multivector<Rational> = samples.element();
        assert_eq!(x.norm_squared(), (x * x.reverse()).s);
        let v: r3::Vector = samples.element();
        near(v.norm(), v.e1.hypot(v.e2).hypot(v.e3), 1e-15);
        let b: r3::Bivector = samples.element();
        // B² < 0, where the print would give a negative norm.
        assert!((b * b).s < 0.0);
        near(b.norm(), b.e12.hypot(b.e13).hypot(b.e23), 1e-15);
        let s: f64 = samples.number();
        near(r3::Scalar::new(s).norm(), s.abs(), 1e-15);
        let time: r1_1_1::Vector = unit::<r1_1_1::Vector>(1) * s;
        assert_eq!(time.norm_squared(), -s * s);
        near(time.norm(), s.abs(), 1e-15);
        let null: r1_1_1::Vector = unit::<r1_1_1::Vector>(2) * s;
        assert_eq!(null.norm(), 0.0);
    });
}

/// The sign that a map has on grade k of the conformal model, where k goes up to 5.
fn has_signs(
    map: impl Fn(cga3::Multivector<Rational>) -> cga3::Multivector<Rational>,
    sign: impl Fn(u32) -> u32,
) {
    each(|samples| {
        let x: cga3::Multivector<Rational> = samples.element();
        for k in 0..=5 {
            let part = x.grade(k);
            let signed = if sign(k).is_multiple_of(2) {
                part
            } else {
                -part
            };
            assert_eq!(map(part), signed, "grade {k}");
        }
    });
}

/// X̃ = (−1)^{k(k−1)/2} X; the print forgets to halve the exponent, which makes all signs +.
#[test]
fn equation_2_22_reversion() {
    has_signs(|x| x.reverse(), |k| k * k.saturating_sub(1) / 2);
}

/// X̂ = (−1)^k X.
#[test]
fn equation_2_23_involution() {
    has_signs(|x| x.involute(), |k| k);
}

/// X̄ = (−1)^{k(k+1)/2} X; the print forgets to halve the exponent. It is the reverse of the
/// involution.
#[test]
fn equation_2_24_conjugation() {
    has_signs(|x| x.conjugate(), |k| k * (k + 1) / 2);
    each(|samples| {
        let x: Multivector = samples.element();
        assert_eq!(x.conjugate(), x.reverse().involute());
    });
}

/// v = (A* ∧ B*)⁻*: two planes through the origin meet in the line along both of them.
#[test]
fn equation_2_25_the_meet_of_two_planes() {
    each(|samples| {
        let [u, v, w]: [Vector; 3] = std::array::from_fn(|_| samples.element());
        // Two planes that share w by construction.
        let (a, b): (Bivector, Bivector) = (u ^ w, v ^ w);
        let meet: Vector = (a.dual() ^ b.dual()).undual();
        assert_eq!(meet ^ w, Bivector::default());
        assert_eq!(meet ^ a, Trivector::default());
        assert_eq!(meet ^ b, Trivector::default());
        assert_ne!(meet, Vector::default(), "u, v, w are independent");
        // Against the metric-free regressive product the sign is (−1)^{[a(a−1) + b(b−1) +
        // c(c−1) + n(n−1)]/2} with c = a + b − n: here (2 + 2 + 0 + 6)/2 = 5, a minus.
        assert_eq!(meet, -(a & b));
        // Parallel planes share no single line.
        let none: Vector = (a.dual() ^ (a * Rational::new(3, 2)).dual()).undual();
        assert_eq!(none, Vector::default());
    });
}
