//! Long batches on one core and on all, by rayon; beside them two threads that have nothing to do
//! with each other, which tells what the machine has to give at that moment.

use rayon::ThreadPool;

use crate::batches::Work;
use crate::machine::fastest;
use crate::verdict;

/// Bytes of operands and results: more than a second cache, and out of all caches.
const BYTES: [usize; 2] = [4 << 20, 256 << 20];
/// The elements of a window, in bytes.
const WINDOW: usize = 32 << 20;
/// How many times as fast as one core two are to be.
const ASKED: f64 = 1.9;
/// How often the three take turns.
const TURNS: usize = 20;

/// Reports all operations, given a pool of one thread for every core, and one of all.
pub fn report(works: &[Work], alone: &[ThreadPool], all: &ThreadPool) {
    let cores = all.current_num_threads();
    println!("one core and {cores}; best of {TURNS} turns of each");
    println!(
        "{:<31} {:<6} {:>4} {:>8} {:>8} {:>6} {:>11}",
        "operation", "scalar", "MiB", "ns", "ns", "gain", "independent"
    );
    for bytes in BYTES {
        for work in works {
            row(work, bytes, alone, all);
        }
    }
    println!(
        "Two cores give what `independent` threads are given at most: they share the memory, and on a \
         rented machine the cores themselves."
    );
}

fn row(work: &Work, bytes: usize, single: &[ThreadPool], all: &ThreadPool) {
    let cores = single.len();
    let count = bytes / work.bytes();
    let calls = WINDOW.div_ceil(bytes);
    let mut call = (work.prepare)(count);
    let mut parts: Vec<_> = (0..cores).map(|_| (work.prepare)(count / cores)).collect();
    let mut repeated = || (0..calls).for_each(|_| call());
    let [mut alone, mut together, mut apart] = [f64::INFINITY; 3];
    for _ in 0..TURNS {
        alone = alone.min(single[0].install(|| fastest(1, &mut repeated)));
        together = together.min(all.install(|| fastest(1, &mut repeated)));
        apart = apart.min(fastest(1, || {
            std::thread::scope(|scope| {
                for (pool, part) in single.iter().zip(&mut parts) {
                    scope.spawn(|| pool.install(|| (0..calls).for_each(|_| part())));
                }
            });
        }));
    }
    let elements = (calls * count) as f64;
    let each = |seconds: f64| seconds * 1e9 / elements;
    let (gain, best) = (alone / together, alone / apart);
    let verdict = match cores {
        2 => verdict(gain, ASKED),
        _ => String::new(),
    };
    println!(
        "{:<31} {:<6} {:>4} {:>8.3} {:>8.3} {gain:>6.2} {best:>11.2}  {verdict}",
        work.name,
        work.scalar,
        bytes >> 20,
        each(alone),
        each(together),
    );
}
