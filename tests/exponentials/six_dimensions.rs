//! Six dimensions: the algebras, and exponentials by scaling and squaring.

use ga::core::ops::{Element, Exponential};

use crate::families::Random;
use crate::space;
use crate::space::{Space, error};

ga::define_algebra!(R6);
ga::define_algebra!(R3_3);
ga::define_algebra!(R4_2);
ga::define_algebra!(R2_4);

/// Random bivectors of every size, and single planes.
fn check<B>(space: &Space)
where
    B: Element<Number = f64> + Exponential<Output: Element<Number = f64>>,
{
    let mut random = Random::new(6);
    for size in [0.0, 1e-200, 1e-8, 0.1, 0.7, 2.0] {
        for round in 0..4 {
            let bivector = B::from_fn(|i| match round {
                0 if i != 3 => 0.0,
                1 if i % 4 != 0 => 0.0,
                _ => size * random.number(),
            });
            let expected = space.exp(&space.value(&bivector));
            let found = error(&space.value(&bivector.exp()), &expected);
            assert!(
                found <= 1e-14,
                "{found:e} for size {size} in {}",
                space.name
            );
        }
    }
}

#[test]
fn exponentials() {
    check::<r6::Bivector>(&space("R6", 6, 0, 0));
    check::<r3_3::Bivector>(&space("R3_3", 3, 3, 0));
    check::<r4_2::Bivector>(&space("R4_2", 4, 2, 0));
    check::<r2_4::Bivector>(&space("R2_4", 2, 4, 0));
}
