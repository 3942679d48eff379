//! How near batches come to what the machine can do: `cargo bench --bench limits` measures
//! multiply-adds and copying, then batches in cache and out of it, and prints the shares.
//!
//! In cache a batch is bound by arithmetic: its slots are those of `slots`, the peak is that of
//! independent multiply-adds in the widest registers. Out of cache it is bound by memory: the
//! bytes of its operands and results, against those of a copy. With rayon, one thread is
//! compared with all of them.

mod batches;
mod machine;
mod slots;

use std::process::ExitCode;

use batches::Work;
use machine::fastest;
use rayon::{ThreadPool, ThreadPoolBuildError, ThreadPoolBuilder};

/// Bytes of operands and results that stay in the first cache.
const CACHED: usize = 24 << 10;
/// Bytes that the last cache holds, and enough work for more than one thread.
const MIDDLE: usize = 4 << 20;
/// Bytes of operands and results far beyond the last cache.
const UNCACHED: usize = 256 << 20;

/// The share of the peak that is asked for in cache.
const OF_PEAK: f64 = 0.90;
/// The share of a copy that is asked for out of cache.
const OF_COPY: f64 = 0.85;
/// How many times as fast as one core two are to be.
const OF_TWO_CORES: f64 = 1.9;

/// The shortest measurement in cache, in calls.
const CALLS: usize = 64;
const WINDOWS: usize = 400;

fn main() -> ExitCode {
    match run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(problem) => {
            eprintln!("no threads: {problem}");
            ExitCode::FAILURE
        }
    }
}

fn run() -> Result<(), ThreadPoolBuildError> {
    let (single, double) = (
        machine::multiply_adds(0.5_f32),
        machine::multiply_adds(0.5_f64),
    );
    let copied = machine::copied();
    println!("instructions: {:?}", ga_lanes::Target::current());
    println!("multiply-adds in a nanosecond: {single:.1} of f32, {double:.1} of f64");
    println!("copied: {copied:.1} GB/s, read and written");
    let works = batches::all();

    println!("\nin cache, one core");
    println!(
        "{:<31} {:<6} {:>5} {:>8} {:>6}",
        "operation", "scalar", "slots", "ns", "share"
    );
    for work in &works {
        let peak = if work.scalar == "f32" { single } else { double };
        let nanoseconds = in_cache(work);
        let share = f64::from(work.slots) / nanoseconds / peak;
        let Work {
            name,
            scalar,
            slots,
            ..
        } = work;
        let verdict = verdict(share, OF_PEAK);
        println!("{name:<31} {scalar:<6} {slots:>5} {nanoseconds:>8.3} {share:>6.2}  {verdict}");
    }

    let (one, all) = (threads(1)?, threads(0)?);
    println!("\nout of cache, one core");
    println!(
        "{:<31} {:<6} {:>5} {:>8} {:>6}",
        "operation", "scalar", "bytes", "ns", "share"
    );
    for work in &works {
        let nanoseconds = on_threads(work, UNCACHED, &one);
        let share = work.bytes as f64 / nanoseconds / copied;
        let Work {
            name,
            scalar,
            bytes,
            ..
        } = work;
        let verdict = verdict(share, OF_COPY);
        println!("{name:<31} {scalar:<6} {bytes:>5} {nanoseconds:>8.3} {share:>6.2}  {verdict}");
    }

    let cores = all.current_num_threads();
    println!("\nbatches of {} MiB, one core and {cores}", MIDDLE >> 20);
    println!(
        "{:<31} {:<6} {:>8} {:>8} {:>6}",
        "operation", "scalar", "ns", "ns", "gain"
    );
    for work in &works {
        let (alone, together) = (
            on_threads(work, MIDDLE, &one),
            on_threads(work, MIDDLE, &all),
        );
        let gain = alone / together;
        let Work { name, scalar, .. } = work;
        let verdict = match cores {
            2 => verdict(gain, OF_TWO_CORES),
            _ => String::new(),
        };
        println!("{name:<31} {scalar:<6} {alone:>8.3} {together:>8.3} {gain:>6.2}  {verdict}");
    }
    Ok(())
}

/// A pool of so many threads; 0 stands for one a core.
fn threads(count: usize) -> Result<ThreadPool, ThreadPoolBuildError> {
    ThreadPoolBuilder::new().num_threads(count).build()
}

/// Nanoseconds an element on batches that stay in the first cache.
fn in_cache(work: &Work) -> f64 {
    let count = CACHED / work.bytes / 64 * 64;
    let mut call = (work.prepare)(count);
    let seconds = fastest(WINDOWS, || (0..CALLS).for_each(|_| call()));
    seconds * 1e9 / (CALLS * count) as f64
}

/// Nanoseconds an element on batches of so many bytes, by the threads of a pool.
fn on_threads(work: &Work, bytes: usize, pool: &ThreadPool) -> f64 {
    let count = bytes / work.bytes;
    let mut call = (work.prepare)(count);
    let windows = (UNCACHED / bytes * 4).clamp(4, 100);
    let seconds = pool.install(|| fastest(windows, call.as_mut()));
    seconds * 1e9 / count as f64
}

/// The share that is asked for, and whether it is reached.
fn verdict(share: f64, asked: f64) -> String {
    let reached = if share >= asked { "reached" } else { "MISSED" };
    format!("asked {asked:.2}, {reached}")
}
