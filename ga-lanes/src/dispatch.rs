//! A kernel is compiled once per target and run on the one that was found.

use core::hint::black_box;
use core::marker::PhantomData;

use crate::lanes::Lanes;
use crate::number::Number;
#[cfg(target_arch = "x86_64")]
use crate::number::{Wide, Widest};
use crate::target::{Found, Target};

/// A computation written once for all lanes.
///
/// Both `run` and what it calls in its inner loop want `#[inline(always)]`: only code that is
/// inlined into the function of the target uses its registers; what is not inlined is as right,
/// but many times slower.
///
/// ```
/// use ga_lanes::{Kernel, Lanes, dispatch};
///
/// /// The sum of all numbers.
/// struct Sum<'a>(&'a [f32]);
///
/// impl Kernel<f32> for Sum<'_> {
///     type Output = f32;
///
///     #[inline(always)]
///     fn run<L: Lanes<f32>>(self) -> f32 {
///         let arrays = L::arrays(self.0);
///         let mut sums = L::splat(0.0);
///         for array in arrays {
///             sums += L::load(array);
///         }
///         let mut lanes = L::array(|_| 0.0);
///         sums.store(&mut lanes);
///         let rest = &self.0[arrays.len() * L::COUNT..];
///         lanes.as_ref().iter().chain(rest).sum()
///     }
/// }
///
/// let numbers: Vec<f32> = (1..=100).map(|n| n as f32).collect();
/// assert_eq!(dispatch(Sum(&numbers)), 5050.0);
/// ```
pub trait Kernel<F: Number> {
    /// What the computation gives.
    type Output;
    /// The computation.
    fn run<L: Lanes<F>>(self) -> Self::Output;
}

/// Runs a kernel on the current target, which is the widest that the machine has.
pub fn dispatch<F: Number, K: Kernel<F>>(kernel: K) -> K::Output {
    run::<F, _>(Found::current(), General(kernel, PhantomData))
}

/// Runs a kernel on the given target; `None`, without a call, where the machine lacks it.
pub fn dispatch_on<F: Number, K: Kernel<F>>(target: Target, kernel: K) -> Option<K::Output> {
    let found = Found::checked(target)?;
    Some(run::<F, _>(found, General(kernel, PhantomData)))
}

/// A computation that gives something.
pub trait Task {
    /// What it gives.
    type Output;
}

/// A computation that runs on lanes `L`: unlike a [`Kernel`], it may exist for some lanes only.
pub trait On<L>: Task {
    /// The computation.
    fn run(self) -> Self::Output;
}

/// A computation for the lanes of all targets.
#[cfg(target_arch = "x86_64")]
pub trait OnEveryTarget<F: Number>: On<F::Portable> + On<Wide<F>> + On<Widest<F>> {}
#[cfg(target_arch = "x86_64")]
impl<F: Number, K: On<F::Portable> + On<Wide<F>> + On<Widest<F>>> OnEveryTarget<F> for K {}

/// A computation for the lanes of all targets.
#[cfg(not(target_arch = "x86_64"))]
pub trait OnEveryTarget<F: Number>: On<F::Portable> {}
#[cfg(not(target_arch = "x86_64"))]
impl<F: Number, K: On<F::Portable>> OnEveryTarget<F> for K {}

/// A line of the cache on the stack.
///
/// A function that has one aligns its stack, and then what overflows the registers. Without it the
/// compiler takes the register for other things that it would need for that, and numbers that
/// straddle two lines take twice the time or more.
#[cfg(target_arch = "x86_64")]
#[repr(align(64))]
struct Aligned([u8; 1]);

/// A kernel as a task.
struct General<F, K>(K, PhantomData<F>);

impl<F: Number, K: Kernel<F>> Task for General<F, K> {
    type Output = K::Output;
}

impl<F: Number, L: Lanes<F>, K: Kernel<F>> On<L> for General<F, K> {
    #[inline(always)]
    fn run(self) -> K::Output {
        self.0.run::<L>()
    }
}

/// Runs a task on a target.
#[cfg(target_arch = "x86_64")]
pub(crate) fn run<F: Number, K: OnEveryTarget<F>>(target: Found, task: K) -> K::Output {
    match target.get() {
        Target::Portable => on_portable::<F, K>(task),
        // SAFETY: the target was found on this machine, and the function has its features only.
        Target::V3 => unsafe { on_v3::<F, K>(task) },
        // SAFETY: the target was found on this machine, and the function has its features only.
        Target::V4 => unsafe { on_v4::<F, K>(task) },
    }
}

/// Runs a task on a target.
#[cfg(not(target_arch = "x86_64"))]
pub(crate) fn run<F: Number, K: OnEveryTarget<F>>(_: Found, task: K) -> K::Output {
    on_portable::<F, K>(task)
}

fn on_portable<F: Number, K: On<F::Portable>>(task: K) -> K::Output {
    task.run()
}

/// Runs a task on machines with AVX2 and fused multiply-add.
#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,fma,bmi1,bmi2,lzcnt")]
pub(crate) fn on_v3<F: Number, K: On<Wide<F>>>(task: K) -> K::Output {
    black_box(&mut Aligned([0]).0);
    task.run()
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,fma,bmi1,bmi2,lzcnt")]
#[target_feature(enable = "avx512f,avx512bw,avx512cd,avx512dq,avx512vl")]
fn on_v4<F: Number, K: On<Widest<F>>>(task: K) -> K::Output {
    black_box(&mut Aligned([0]).0);
    task.run()
}
