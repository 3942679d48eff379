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

/// Numbers that are loaded and stored with hardly any arithmetic.
struct Streams<'t, F> {
    from: &'t [F],
    to: &'t mut [F],
    /// How many vectors are loaded at a time.
    read: usize,
    /// How many vectors are stored then.
    written: usize,
}

impl<F: Number> Kernel<F> for Streams<'_, F> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes<F>>(self) {
        let loaded = L::arrays(self.from).chunks_exact(self.read);
        let stored = L::arrays_mut(self.to).chunks_exact_mut(self.written);
        for (loaded, stored) in loaded.zip(stored) {
            let mut sums = [L::ZERO; 4];
            let mut fours = loaded.chunks_exact(4);
            for four in &mut fours {
                for (sum, array) in sums.iter_mut().zip(four) {
                    *sum += L::load(array);
                }
            }
            for (sum, array) in sums.iter_mut().zip(fours.remainder()) {
                *sum += L::load(array);
            }
            let sum = (sums[0] + sums[1]) + (sums[2] + sums[3]);
            for array in stored {
                sum.store(array);
            }
        }
    }
}

/// Nanoseconds an element for loading and storing so many numbers of it, of so many elements.
pub fn streamed<F: Number>(count: usize, read: usize, written: usize, calls: usize) -> f64 {
    let from = vec![F::ONE; count * read + F::LINE];
    let mut to = vec![F::ONE; count * written + F::LINE];
    // From the beginning of a line of the cache on.
    let begin = |numbers: &[F]| numbers.as_ptr().align_offset(64).min(F::LINE);
    let (first, begun) = (begin(&from), begin(&to));
    let seconds = fastest(WINDOWS, || {
        for _ in 0..calls {
            dispatch(Streams {
                from: black_box(&from[first..][..count * read]),
                to: black_box(&mut to[begun..][..count * written]),
                read,
                written,
            });
        }
    });
    seconds * 1e9 / (calls * count) as f64
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

/// Two arrays of so many bytes together, of which one is copied to the other.
pub struct Copy {
    from: Vec<u64>,
    to: Vec<u64>,
}

impl Copy {
    /// The arrays.
    pub fn new(bytes: usize) -> Self {
        Copy {
            from: vec![1; bytes / 16],
            to: vec![2; bytes / 16],
        }
    }

    /// Copies once.
    pub fn run(&mut self) {
        self.to.copy_from_slice(black_box(&self.from));
        black_box(&mut self.to);
    }

    /// The bytes that are read and written.
    pub fn bytes(&self) -> usize {
        2 * size_of_val(self.from.as_slice())
    }
}
