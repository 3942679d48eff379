//! Batches in cache on one core: the share of the machine's multiply-adds, and what else bounds
//! them.
//!
//! The slots of an operation are those of `slots`, the peak is that of independent multiply-adds in
//! the registers of the target. A share above 1 is possible where a machine adds beside its
//! multiply-adds. A batch takes its numbers from the cache too: `moved` is what loading and storing
//! as many takes by itself, from batches of the same size.

use ga_lanes::Target;

use crate::batches::{self, Work};
use crate::machine::{self, fastest};
use crate::verdict;

/// Bytes of operands and results that stay in the first cache.
const FIRST: usize = 24 << 10;
/// The number of elements in the second cache.
const SECOND: usize = 4096;
/// The share of the peak that is asked for.
const ASKED: f64 = 0.90;
const WINDOWS: usize = 400;
/// The elements of a window, at least.
const WINDOW: usize = 16 << 10;

/// Reports all operations on the current target.
pub fn report(works: &[Work]) {
    let (single, double) = (
        machine::multiply_adds(0.5_f32),
        machine::multiply_adds(0.5_f64),
    );
    println!("in cache, one core, {:?}", Target::current());
    println!("multiply-adds in a nanosecond: {single:.1} of f32, {double:.1} of f64");
    println!(
        "{:<31} {:<6} {:>8} {:>5} {:>8} {:>6} {:>8} {:>9}",
        "operation", "scalar", "elements", "slots", "ns", "share", "moved ns", "of bound"
    );
    for work in works {
        let peak = if work.scalar == "f32" { single } else { double };
        for count in [FIRST / work.bytes() / 64 * 64, SECOND] {
            row(work, count, peak);
        }
    }
    println!("{REMARK}\n");
}

/// Why shares are missed where they are, and what was tried.
const REMARK: &str = "\
Of what is missed: one motor on all has 9 to 13 slots for an element that is loaded and stored, and \
short calls are felt; a motor and a circle are 18 coefficients, which 16 registers of V3 do not hold, \
so that the compiler keeps some on the stack (aligned, since that takes half of the time of unaligned \
ones); 4096 elements are in the second cache, where `moved` is the time of its loads and stores alone. \
Tried: views of columns that are made once a call, elements two by two, one matrix for all.";

fn row(work: &Work, count: usize, peak: f64) {
    let calls = WINDOW.div_ceil(count);
    let mut call = (work.prepare)(count);
    let seconds = fastest(WINDOWS, || (0..calls).for_each(|_| call()));
    let nanoseconds = seconds * 1e9 / (calls * count) as f64;
    let Work {
        name,
        scalar,
        slots,
        read,
        written,
        ..
    } = *work;
    let moved = match scalar {
        "f32" => machine::streamed::<f32>(count, read, written, calls),
        _ => machine::streamed::<f64>(count, read, written, calls),
    };
    let computed = f64::from(slots) / peak;
    let (share, of_bound) = (computed / nanoseconds, computed.max(moved) / nanoseconds);
    let verdict = match share < ASKED && of_bound >= ASKED && moved > computed {
        true => String::from("bound by loads and stores"),
        false => verdict(share, ASKED),
    };
    println!(
        "{name:<31} {scalar:<6} {count:>8} {slots:>5} {nanoseconds:>8.3} {share:>6.2} \
         {moved:>8.3} {of_bound:>9.2}  {verdict}"
    );
}

/// Reports exponentials and logarithms on all targets.
pub fn report_functions() {
    println!("exponentials and logarithms of {SECOND} motors, one core, ns");
    print!("{:<31} {:<6}", "operation", "scalar");
    for target in Target::ALL {
        print!(" {:>8}", format!("{target:?}"));
    }
    println!();
    for function in batches::functions() {
        print!("{:<31} {:<6}", function.name, function.scalar);
        for target in Target::ALL {
            let seconds = target.scope(|| fastest(WINDOWS, (function.prepare)(SECOND)));
            match seconds {
                Some(seconds) => print!(" {:>8.3}", seconds * 1e9 / SECOND as f64),
                None => print!(" {:>8}", "–"),
            }
        }
        println!();
    }
    println!();
}
