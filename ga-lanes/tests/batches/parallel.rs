//! Long batches, which several threads share: the same results, bit for bit.

use ga_lanes::{Batch, One, Target};

use super::plane::{Motor, Pair, Point};
use super::samples::{elements, on_every_target};

/// Longer than what one thread takes alone, and no multiple of anything.
const LONG: usize = 40_003;

#[test]
fn long_batches_agree_with_their_parts() {
    on_every_target(|| {
        let (motors, points) = (
            elements::<Motor<f32>>(LONG, 1),
            elements::<Point<f32>>(LONG, 2),
        );
        let pairs = elements::<Pair<f32>>(LONG, 3);
        let one = motors[0];
        let whole = Batch::from_slice(&motors)
            .apply(&Batch::from_slice(&points))
            .unwrap();
        let mut in_place = Batch::from_slice(&points);
        One(one).apply_in_place(&mut in_place);
        let inverses = Batch::from_slice(&pairs).inverse();
        for start in (0..LONG).step_by(1000) {
            let part = start..(start + 1000).min(LONG);
            let some = Batch::from_slice(&points[part.clone()]);
            let images = Batch::from_slice(&motors[part.clone()])
                .apply(&some)
                .unwrap();
            assert!(
                images.iter().eq(whole.iter().skip(start).take(1000)),
                "{:?}",
                Target::current()
            );
            let images = One(one).apply(&some);
            assert!(images.iter().eq(in_place.iter().skip(start).take(1000)));
            let some = Batch::from_slice(&pairs[part]).inverse();
            assert!(some.iter().eq(inverses.iter().skip(start).take(1000)));
        }
    });
}
