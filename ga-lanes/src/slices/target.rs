//! Slices are computed in 256 bits at most: what a block costs beside the arithmetic is shuffles,
//! and those of 512 bits take longer than two of 256.

use crate::dispatch::On;
#[cfg(target_arch = "x86_64")]
use crate::dispatch::on_v3;
use crate::number::Number;
#[cfg(target_arch = "x86_64")]
use crate::number::Wide;
use crate::target::{Found, Target};

/// A task for the lanes of the targets that slices are computed on.
#[cfg(target_arch = "x86_64")]
pub trait OnTargets<F: Number>: On<F::Portable, Output = ()> + On<Wide<F>, Output = ()> {}
#[cfg(target_arch = "x86_64")]
impl<F: Number, K: On<F::Portable, Output = ()> + On<Wide<F>, Output = ()>> OnTargets<F> for K {}

/// A task for the lanes of the targets that slices are computed on.
#[cfg(not(target_arch = "x86_64"))]
pub trait OnTargets<F: Number>: On<F::Portable, Output = ()> {}
#[cfg(not(target_arch = "x86_64"))]
impl<F: Number, K: On<F::Portable, Output = ()>> OnTargets<F> for K {}

/// Runs a task on the current target.
#[cfg(target_arch = "x86_64")]
pub fn run<F: Number, K: OnTargets<F>>(task: K) {
    match Found::current().get() {
        Target::Portable => On::<F::Portable>::run(task),
        // SAFETY: a machine with one of these targets has the instructions of the first, and the
        // function has its features only.
        Target::V3 | Target::V4 => unsafe { on_v3::<F, K>(task) },
    }
}

/// Runs a task on the current target.
#[cfg(not(target_arch = "x86_64"))]
pub fn run<F: Number, K: OnTargets<F>>(task: K) {
    On::<F::Portable>::run(task);
}
