//! Batches far beyond the last cache on one core: the bytes of operands and results, against those
//! of a copy that is measured in turns with them.

use crate::batches::Work;
use crate::machine::{Copy, fastest};
use crate::verdict;

/// Bytes of operands and results.
const BYTES: usize = 256 << 20;
/// The share of a copy that is asked for.
const ASKED: f64 = 0.85;
/// How often copy and operation take turns.
const TURNS: usize = 8;

/// Reports all operations.
pub fn report(works: &[Work]) {
    println!("out of cache, one core; a copy in turns, GB/s read and written");
    println!(
        "{:<31} {:<6} {:>5} {:>8} {:>6} {:>6} {:>6}",
        "operation", "scalar", "bytes", "ns", "GB/s", "copy", "share"
    );
    for work in works {
        let Work { name, scalar, .. } = work;
        let bytes = work.bytes();
        let count = BYTES / bytes;
        let mut copy = Copy::new(BYTES);
        let mut call = (work.prepare)(count);
        let (mut copying, mut computing) = (f64::INFINITY, f64::INFINITY);
        for _ in 0..TURNS {
            copying = copying.min(fastest(1, || copy.run()));
            computing = computing.min(fastest(1, call.as_mut()));
        }
        let copied = copy.bytes() as f64 / (copying * 1e9);
        let nanoseconds = computing * 1e9 / count as f64;
        let moved = bytes as f64 / nanoseconds;
        let share = moved / copied;
        let verdict = verdict(share, ASKED);
        println!(
            "{name:<31} {scalar:<6} {bytes:>5} {nanoseconds:>8.3} {moved:>6.1} {copied:>6.1} \
             {share:>6.2}  {verdict}"
        );
    }
    println!(
        "A motor on a circle of its own goes through 28 columns at once, where a copy goes through two; \
         arrays of structs, as `slices` takes them, are two streams and an image.\n"
    );
}
