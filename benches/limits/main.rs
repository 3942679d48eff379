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

fn main() -> ExitCode {
    let peaks = [machine::multiply_adds(0.5_f32), machine::multiply_adds(0.5_f64)];
    let copied = machine::copied();
    println!("instructions: {:?}", ga_lanes::Target::current());
    println!("multiply-adds in a nanosecond: {:.1} f32, {:.1} f64", peaks[0], peaks[1]);
    println!("copied, read and written: {copied:.1} GB/s\n");
    batches::in_cache(peaks);
    println!();
    batches::out_of_cache(copied);
    println!();
    match batches::on_all_cores() {
        Ok(()) => ExitCode::SUCCESS,
        Err(problem) => {
            eprintln!("{problem}");
            ExitCode::FAILURE
        }
    }
}
