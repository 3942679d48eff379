//! How near batches come to what the machine can do: `cargo bench --bench limits` measures
//! multiply-adds, loads and stores, and copying, then batches in cache and out of it, and prints
//! the shares.

mod batches;
mod cache;
mod cores;
mod machine;
mod memory;
mod slots;

use std::process::ExitCode;

use ga_lanes::Target;
use rayon::{ThreadPool, ThreadPoolBuildError, ThreadPoolBuilder};

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
    let all = threads(0)?;
    let single = (0..all.current_num_threads()).map(|_| threads(1));
    let single = single.collect::<Result<Vec<_>, _>>()?;
    let works = batches::all();
    for target in [Target::V4, Target::V3] {
        let measured = target.scope(|| cache::report(&works));
        if measured.is_none() {
            println!("{target:?}: not on this machine\n");
        }
    }
    cache::report_functions();
    single[0].install(|| memory::report(&works));
    cores::report(&works, &single, &all);
    Ok(())
}

/// A pool of so many threads; 0 stands for one a core.
fn threads(count: usize) -> Result<ThreadPool, ThreadPoolBuildError> {
    ThreadPoolBuilder::new().num_threads(count).build()
}

/// The share that is asked for, and whether it is reached.
fn verdict(share: f64, asked: f64) -> String {
    let reached = if share >= asked { "reached" } else { "MISSED" };
    format!("asked {asked:.2}, {reached}")
}
