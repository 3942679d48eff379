//! The closed form of the roots against the construction of 3.2.1, and the numbers without roots.

use std::f64::consts::PI;

use ga_cga::{Bivector3, Rotor, Trivector3, Vector3};
use ga_design::crystallography::{Roots, RootsError};

/// (3.6–3.8): two copies of the plane a∧c, turned about a and about c, met.
fn met(p: u32, q: u32) -> Vector3 {
    let (alpha, gamma) = (PI / f64::from(q), PI / f64::from(p));
    let about_a = (alpha.cos() / gamma.sin()).clamp(-1.0, 1.0).acos();
    let about_c = (gamma.cos() / alpha.sin()).clamp(-1.0, 1.0).acos();
    let plane = Vector3::new(1.0, 0.0, 0.0) ^ Vector3::new(0.0, 0.0, 1.0);
    // R_A = e^{A e₂₃/2} and R_C = e^{−C e₁₂/2}.
    let rotor_a: Rotor = (Bivector3::new(0.0, 0.0, 1.0) * (about_a / 2.0)).exp();
    let rotor_c: Rotor = (Bivector3::new(1.0, 0.0, 0.0) * (-about_c / 2.0)).exp();
    let dual = |plane: Bivector3| plane * Trivector3::new(-1.0);
    let duals = dual(rotor_c.apply(plane)) ^ dual(rotor_a.apply(plane));
    let met: Vector3 = duals * Trivector3::new(1.0);
    met.normalized().expect("two planes that meet")
}

#[test]
fn the_closed_form_is_where_the_rotated_planes_meet() {
    let polyhedral = [(3, 3), (3, 4), (4, 3), (3, 5), (5, 3)];
    let dihedral = (2..=40).flat_map(|n| [(n, 2), (2, n)]);
    for (p, q) in polyhedral.into_iter().chain(dihedral) {
        let roots = Roots::new(p, q).expect("a point group");
        let apart = (roots.b - met(p, q)).norm();
        assert!(apart < 1e-12, "{p}, {q}: off by {apart:e}");
    }
}

#[test]
fn products_of_roots_have_the_orders_of_their_angles() {
    for (p, q) in [
        (1, 2),
        (2, 1),
        (2, 2),
        (3, 2),
        (5, 3),
        (4, 3),
        (8, 2),
        (2, 7),
    ] {
        let roots = Roots::new(p, q).expect("a point group");
        assert_eq!((roots.p(), roots.q()), (p, q));
        let [a, b, c] = roots.vectors();
        for (first, second, n) in [(a, b, p), (b, c, q), (c, a, 2)] {
            assert!((first.norm() - 1.0).abs() < 1e-15);
            let product: Rotor = first * second;
            let power = (1..n).fold(product, |power, _| power * product);
            assert!(
                (power + Rotor::identity()).norm() < 1e-13,
                "{p}, {q}: {power}"
            );
        }
    }
}

#[test]
fn numbers_that_do_not_close_are_refused_by_name() {
    for (p, q) in [
        (4, 5),
        (5, 4),
        (3, 7),
        (6, 4),
        (5, 5),
        (1000, 3),
        (1, 1),
        (1, 3),
        (7, 1),
    ] {
        let error = Roots::new(p, q).expect_err("no point group");
        assert!(
            matches!(error, RootsError::Open { p: one, q: other, radicand } if one == p && other == q && radicand < 0.0),
            "{p}, {q}: {error}"
        );
        let text = error.to_string();
        assert!(text.contains(&format!("p = {p}, q = {q}")), "{text}");
        assert!(text.contains("negative"), "{text}");
    }
    for (p, q) in [(4, 4), (6, 3), (3, 6)] {
        let error = Roots::new(p, q).expect_err("a tiling of the plane");
        assert_eq!(error, RootsError::Planar { p, q });
        assert!(error.to_string().contains("one plane"), "{error}");
    }
    let error = Roots::new(0, 3).expect_err("no angle");
    assert_eq!(
        error,
        RootsError::Number {
            name: 'p',
            value: 0
        }
    );
    let error = Roots::new(2, 1001).expect_err("too fine");
    assert_eq!(
        error,
        RootsError::Number {
            name: 'q',
            value: 1001
        }
    );
    assert!(error.to_string().contains("q = 1001"), "{error}");
    assert!(Roots::new(u32::MAX, u32::MAX).is_err());
}
