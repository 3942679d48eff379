//! What the machine can do at most, measured: multiply-adds in registers, and copying.

use std::hint::black_box;
use std::time::Instant;

use ga_lanes::{Kernel, Lanes, Number, dispatch};

/// Independent chains of multiply-adds: more than the latency of two units, and few enough for
/// sixteen registers.
const CHAINS: usize = 12;
const LINKS: usize = 1000;

/// Multiply-adds that do not wait for each other.
struct MultiplyAdds<F>(F);

impl<F: Number> Kernel<F> for MultiplyAdds<F> {
    /// How many there were, and what came out.
    type Output = (usize, F);

    #[inline(always)]
    fn run<L: Lanes<F>>(self) -> (usize, F) {
        let (factor, mut chains) = (L::splat(self.0), [L::splat(self.0); CHAINS]);
        for _ in 0..LINKS {
            for chain in &mut chains {
                *chain = factor.plus_product(*chain, factor);
            }
        }
        let sum = chains
            .into_iter()
            .fold(L::splat(F::ZERO), |sum, chain| sum + chain);
        let mut lanes = L::array(|_| F::ZERO);
        sum.store(&mut lanes);
        let first = lanes.as_ref().first().copied().unwrap_or(F::ZERO);
        (CHAINS * LINKS * L::COUNT, first)
    }
}

/// Windows of each measurement.
pub const WINDOWS: usize = 200;

/// Seconds of the fastest of many calls.
pub fn fastest(windows: usize, mut call: impl FnMut()) -> f64 {
    let window = |_| {
        let start = Instant::now();
        call();
        start.elapsed().as_secs_f64()
    };
    (0..windows).map(window).fold(f64::INFINITY, f64::min)
}

/// Multiply-adds in a nanosecond, of numbers of this type.
pub fn multiply_adds<F: Number>(half: F) -> f64 {
    let mut count = 0;
    let seconds = fastest(WINDOWS * 10, || {
        let (products, value) = dispatch(MultiplyAdds(black_box(half)));
        count = products;
        black_box(value);
    });
    count as f64 / (seconds * 1e9)
}

/// Bytes of the arrays that are copied: many times the caches.
pub const COPIED: usize = 256 << 20;

/// Bytes read and written in a nanosecond by a copy from memory to memory.
pub fn copied() -> f64 {
    let from = vec![1_u64; COPIED / 8];
    let mut to = vec![2_u64; COPIED / 8];
    let seconds = fastest(5, || {
        to.copy_from_slice(black_box(&from));
        black_box(&mut to);
    });
    2.0 * COPIED as f64 / (seconds * 1e9)
}
