//! Polar normalisation removes drift, of whichever kind.

use ga::cga::cga3;
use ga::core::ops::{Element, Exponential, Renormalize};

use crate::families::Random;
use crate::space::{Space, error, largest};
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

/// In five dimensions an even element has a polar factor too, but it is a versor only if the
/// element was nearly one.
#[test]
fn five_dimensions() {
    for drift in [1e-8, 1e-15] {
        let bivector = r5::Bivector::from([0.3, 0.1, -0.4, 0.2, 0.5, -0.1, 0.7, 0.2, 0.0, 0.4]);
        let versor = bivector.exp();
        let mut random = Random::new(3);
        let moved = versor.map(|x| x + drift * random.number());
        let found = moved.renormalized().expect("near a versor");
        let product = found * found.reverse();
        let excess = product - r5::Even::from(r5::Scalar::new(1.0));
        let largest = excess
            .to_array()
            .into_iter()
            .fold(0.0, |m: f64, x| m.max(x.abs()));
        assert!(largest <= 1e-14, "{largest:e}");
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
