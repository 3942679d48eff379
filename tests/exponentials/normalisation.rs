//! Polar normalisation removes drift, of whichever kind.

use ga::cga::cga3;
use ga::core::ops::{Element, Exponential, Logarithm, Renormalize};

use crate::families::Random;
use crate::space::{Space, Value, error, largest};
use crate::wide::Wide;
use crate::{conformal_space, r1_3, r3, r3_0_1, r4, r5, space};

/// A versor with every coefficient moved comes back to a unit one near it.
fn check<B, R>(space: &Space, drift: f64)
where
    B: Element<Number = f64> + Exponential<Output = R>,
    R: Element<Number = f64> + Renormalize<Output = R>,
{
    let mut random = Random::new(91);
    for _ in 0..200 {
        let bivector = B::from_fn(|_| random.number());
        let versor = bivector.exp();
        let moved = R::from_fn(|i| 3.0 * (versor.at(i) + drift * random.number()));
        let found = moved.renormalized().expect("near a versor");
        let value = space.value(&found);
        let product = space.times(&value, &value.reverse());
        let one = space.algebra.scalar(Wide::from(1.0));
        let size = largest(&value).max(1.0).powi(2);
        assert!(error(&product, &one) <= 4e-15 * size, "{}", space.name);
        assert!(error(&value, &space.value(&versor)) <= 60.0 * size * drift + 1e-14);
    }
}

#[test]
fn drift_is_removed() {
    for drift in [1e-3, 1e-8, 1e-15] {
        check::<r3::Bivector, r3::Even>(&space("R3", 3, 0, 0), drift);
        check::<r4::Bivector, r4::Even>(&space("R4", 4, 0, 0), drift);
        check::<r1_3::Bivector, r1_3::Even>(&space("R1_3", 1, 3, 0), drift);
        check::<r3_0_1::Bivector, r3_0_1::Even>(&space("R3_0_1", 3, 0, 1), drift);
        check::<cga3::DualLine, cga3::Motor>(&conformal_space(), drift);
    }
}

/// In five dimensions X X̃ need not commute with X, so the side of the root matters: from the left
/// it gives a versor however far X is from one, from the right it does not.
#[test]
fn five_dimensions() {
    let space = space("R5", 5, 0, 0);
    let one = space.algebra.scalar(Wide::from(1.0));
    let mut random = Random::new(3);
    for drift in [0.3, 1e-8, 1e-15] {
        let bivector = r5::Bivector::from([0.3, 0.1, -0.4, 0.2, 0.5, -0.1, 0.7, 0.2, 0.0, 0.4]);
        let moved = bivector.exp().map(|x| x + drift * random.number());
        let found = moved.renormalized().expect("near a versor");
        let (x, unit) = (space.value(&moved), space.value(&found));
        let square = |value: &Value| space.times(value, &value.reverse());
        assert!(error(&square(&unit), &one) <= 1e-14, "{drift}");
        for vector in &space.frame {
            let image = space.times(&space.times(&unit, vector), &unit.reverse());
            assert!(error(&image.grade(1), &image) <= 1e-14, "{drift}");
        }
        // U X̃ is the root of X X̃: its own reverse, and its square.
        let root = space.times(&unit, &x.reverse());
        assert!(error(&root.reverse(), &root) <= 1e-14, "{drift}");
        assert!(
            error(&space.times(&root, &root), &square(&x)) <= 1e-14,
            "{drift}"
        );
        let other_side = space.times(&x, &root.inverse().expect("positive"));
        let missed = error(&square(&other_side), &one);
        assert!(drift < 0.1 || missed > 1e-3, "{missed:e}");
    }
}

#[test]
fn what_has_no_inverse_root_says_so() {
    assert!(r4::Even::<f64>::default().renormalized().is_none());
    assert!(r3::Even::<f64>::default().renormalized().is_none());
    // (1 + e1234)/2 is a projection: X X̃ = X.
    let projection = r4::Even::new(0.5, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.5);
    assert!(projection.renormalized().is_none());
    let negative = r1_3::Even::new(1.0, 3.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    assert!(negative.renormalized().is_none());
    assert!(
        r4::Even::new(f64::NAN, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
            .renormalized()
            .is_none()
    );
}

/// What is promised is not asked, and the same where it holds.
#[test]
fn logarithms_of_promised_unit_versors() {
    for size in [0.0, 1e-9, 0.3, 1.2, 1.5] {
        let rotor = r3::Bivector::new(0.5, -0.7, 0.4) * size;
        assert_eq!(rotor.exp().log_of_unit(), rotor.exp().log());
        let line = cga3::DualLine::new(0.5, 0.3, -0.2, 0.1, 0.6, -0.4) * size;
        assert_eq!(line.exp().log_of_unit(), line.exp().log());
        let pair = cga3::PointPair::from(line) * 0.5;
        assert_eq!(pair.exp().log_of_unit(), pair.exp().log());
    }
    assert_eq!(r3::Even::new(-1.0, 0.0, 0.0, 0.0).log_of_unit(), None);
    let twice = r3::Even::new(2.0, 0.0, 0.0, 0.0);
    assert_eq!(twice.log_of_unit(), None);
    assert_eq!(twice.log(), Some(r3::Bivector::default()));
}
