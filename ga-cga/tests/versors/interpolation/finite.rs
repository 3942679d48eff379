//! Whatever finite numbers come in, a path is refused, or finite and ends where it should.

use super::law::apart;
use crate::random::Random;
use ga_cga::interpolate::{Carry, Connect, Resemble, Way};
use ga_cga::*;
use ga_core::ops::Element;

/// A number of any size, zero often.
fn number(random: &mut Random) -> f64 {
    const EXTREMES: [f64; 8] = [
        f64::MAX,
        -f64::MAX,
        f64::MIN_POSITIVE,
        5e-324,
        1e200,
        -1e-200,
        1e160,
        -1e-160,
    ];
    let which = ((random.number() + 1.0) * 8.0) as usize;
    match which {
        0..4 => 0.0,
        4..9 => 2.0 * random.number(),
        9..12 => 10.0_f64.powf(20.0 * random.number()) * random.number().signum(),
        12..14 => 10.0_f64.powf(300.0 * random.number()) * random.number().signum(),
        _ => EXTREMES[((random.number() + 1.0) * 3.999) as usize],
    }
}

fn any<X: Element<Number = f64>>(random: &mut Random) -> X {
    X::from_fn(|_| number(random))
}

fn finite<X: Element<Number = f64>>(x: X) -> bool {
    (0..X::BLADES.len()).all(|i| x.at(i).is_finite())
}

/// What may come between two elements: no number that is none, and nothing infinite unless a
/// coefficient is so near to the end of the range that what is as large as both can be beyond it.
fn between<X: Element<Number = f64>>(from: X, to: X, at: X) -> bool {
    let mut sizes = (0..X::BLADES.len())
        .flat_map(|i| [from.at(i).abs(), to.at(i).abs()])
        .filter(|size| *size > 0.0);
    let ordinary = sizes.all(|size| (1e-70..1e70).contains(&size));
    finite(at) || !ordinary && (0..X::BLADES.len()).all(|i| !at.at(i).is_nan())
}

/// Paths between any two elements, close ones, and an element and itself.
fn judge<X: Carry<Number = f64> + core::fmt::Debug>(random: &mut Random) -> u32 {
    let mut found = 0;
    let (a, b): (X, X) = (any(random), any(random));
    let near = X::from_fn(|i| a.at(i) * (1.0 + 1e-12 * random.number()));
    for (from, to) in [(a, b), (a, near), (a, a)] {
        for way in [Way::Short, Way::Long] {
            for path in [from.path_to(to, way), from.path_to_either(to, way)] {
                let Ok(path) = path else { continue };
                found += 1;
                for t in [0.0, 0.3, 0.5, 1.0] {
                    let at = path.at(t);
                    let fine = between(from, to, at) && (finite(at) || t % 1.0 != 0.0);
                    assert!(fine, "{from:?} to {to:?} at {t}: {at:?}");
                }
                let halves = |x: X| X::from_fn(|i| x.at(i) * 0.5_f64.powi(3));
                let end = apart(halves(path.at(1.0)), halves(to));
                let scaled = X::from_fn(|i| -to.at(i));
                let reversed = apart(halves(path.at(1.0)), halves(scaled));
                assert!(
                    end.min(reversed) < 1e-5,
                    "{from:?} to {to:?}: {:?}",
                    path.at(1.0)
                );
            }
        }
    }
    found
}

#[test]
fn elements_of_any_size_are_carried_or_refused() {
    let mut random = Random::new(121);
    macro_rules! all {
        ($rounds:literal: $($Element:ident)*) => {$(
            let mut found = 0;
            for _ in 0..$rounds {
                found += judge::<$Element>(&mut random);
            }
            assert!(found > 0, "{}", stringify!($Element));
        )*};
    }
    all! { 400:
        Scalar Vector3 Bivector3 Trivector3 DualSphere DualPlane PointPair FlatPoint
        DirectionVector TangentVector DualLine MinkowskiPlane Circle Line DirectionBivector
        TangentBivector Sphere Plane DirectionTrivector TangentTrivector Pseudoscalar
    }
}

/// Rounds and points by their places, which are blades whatever their size.
#[test]
fn rounds_of_any_size_are_carried_or_refused() {
    let mut random = Random::new(122);
    let mut found = 0;
    for _ in 0..1_000 {
        let mut sphere = || {
            let center = Point::from(any::<Vector3>(&mut random));
            DualSphere::about(center, number(&mut random)) * number(&mut random)
        };
        let (a, b) = (sphere(), sphere());
        let paths = [a.path_to(b, Way::Short), a.similar_path_to(b, Way::Short)];
        for path in paths.into_iter().flatten() {
            found += 1;
            assert!([0.0, 0.3, 1.0].into_iter().all(|t| finite(path.at(t))));
        }
        let [u, v]: [Vector3; 2] = [any(&mut random), any(&mut random)];
        let pair = |sphere: DualSphere, along| sphere.pair_along(along);
        let circle =
            |sphere: DualSphere, along: Vector3| sphere.circle_in(along.orthogonal_plane());
        for path in [
            pair(a, u).path_to(pair(b, v), Way::Short),
            pair(a, u).similar_path_to(pair(b, v), Way::Short),
        ] {
            assert!(path.is_err() || path.is_ok_and(|path| finite(path.at(0.4))));
        }
        for path in [
            circle(a, u).path_to(circle(b, v), Way::Short),
            circle(a, u).similar_path_to(circle(b, v), Way::Long),
        ] {
            assert!(path.is_err() || path.is_ok_and(|path| finite(path.at(0.4))));
        }
        let [p, q]: [Point; 2] = [u, v].map(Point::from);
        if let Ok(path) = p.path_to(q, Way::Short) {
            assert!(finite(path.at(0.0)) && finite(path.at(1.0)), "{p} to {q}");
        }
    }
    assert!(found > 50, "{found}");
}

#[test]
fn versors_of_any_size_are_joined_or_refused() {
    let mut random = Random::new(123);
    macro_rules! all {
        ($($Versor:ident)*) => {$(
            let mut found = 0;
            for _ in 0..1_000 {
                let (a, b): ($Versor, $Versor) = (any(&mut random), any(&mut random));
                for (from, to) in [(a, b), (a, a)] {
                    for way in [Way::Short, Way::Long] {
                        let Ok(path) = from.versor_path_to(to, way) else { continue };
                        found += 1;
                        let [start, middle, end] = [0.0, 0.3, 1.0].map(|t| path.at(t));
                        assert!(finite(start) && finite(end), "{from:?} to {to:?}");
                        assert!(between(from, to, middle), "{from:?} to {to:?}: {middle:?}");
                    }
                }
            }
            assert!(found > 0, "{}", stringify!($Versor));
        )*};
    }
    all! { Rotor Translator Motor Dilator Transversor Even Odd }
}
