//! Which instructions a kernel may use, found out at run time.

use core::cell::Cell;
use std::sync::OnceLock;

/// A set of instructions that kernels are compiled for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Target {
    /// What the compiler was told that every machine has: 128 bits, `f32x4` and `f64x2`, with SSE2
    /// on x86-64 and Neon on 64-bit ARM.
    Portable,
    /// x86-64-v3, AVX2 with fused multiply-add: 256 bits, `f32x8` and `f64x4`.
    V3,
    /// x86-64-v4, AVX-512: 512 bits, `f32x16` and `f64x8`.
    V4,
}

thread_local! {
    /// The target that [`Target::scope`] asks for on this thread.
    static CHOSEN: Cell<Option<Found>> = const { Cell::new(None) };
}

impl Target {
    /// All targets, from the narrowest to the widest.
    pub const ALL: [Target; 3] = [Target::Portable, Target::V3, Target::V4];

    /// Whether this machine has the instructions.
    pub fn is_available(self) -> bool {
        match self {
            Target::Portable => true,
            #[cfg(target_arch = "x86_64")]
            Target::V3 => {
                is_x86_feature_detected!("avx2")
                    && is_x86_feature_detected!("fma")
                    && is_x86_feature_detected!("bmi1")
                    && is_x86_feature_detected!("bmi2")
                    && is_x86_feature_detected!("lzcnt")
            }
            #[cfg(target_arch = "x86_64")]
            Target::V4 => {
                Target::V3.is_available()
                    && is_x86_feature_detected!("avx512f")
                    && is_x86_feature_detected!("avx512bw")
                    && is_x86_feature_detected!("avx512cd")
                    && is_x86_feature_detected!("avx512dq")
                    && is_x86_feature_detected!("avx512vl")
            }
            #[cfg(not(target_arch = "x86_64"))]
            Target::V3 | Target::V4 => false,
        }
    }

    /// The widest target that this machine has.
    pub fn widest() -> Target {
        static WIDEST: OnceLock<Target> = OnceLock::new();
        *WIDEST.get_or_init(|| {
            let available = Target::ALL.into_iter().rev().find(|t| t.is_available());
            available.unwrap_or(Target::Portable)
        })
    }

    /// The target of batches and of [`dispatch`](crate::dispatch) on this thread: the widest one
    /// outside of [`scope`](Target::scope).
    pub fn current() -> Target {
        Found::current().get()
    }

    /// Calls a function during which this target is the current one of the thread, for
    /// comparisons and tests; `None`, without a call, where the machine lacks it.
    ///
    /// ```
    /// use ga_lanes::Target;
    ///
    /// assert_eq!(Target::Portable.scope(Target::current), Some(Target::Portable));
    /// ```
    pub fn scope<R>(self, function: impl FnOnce() -> R) -> Option<R> {
        /// Puts the former choice back, after a panic too.
        struct Former(Option<Found>);
        impl Drop for Former {
            fn drop(&mut self) {
                CHOSEN.set(self.0);
            }
        }
        let found = Found::checked(self)?;
        let _former = Former(CHOSEN.replace(Some(found)));
        Some(function())
    }
}

/// A target that this machine was found to have.
#[derive(Clone, Copy)]
pub(crate) struct Found(Target);

impl Found {
    /// The current target of this thread.
    pub(crate) fn current() -> Found {
        CHOSEN.get().unwrap_or_else(|| Found(Target::widest()))
    }

    /// The target, if the machine has it.
    pub(crate) fn checked(target: Target) -> Option<Found> {
        target.is_available().then_some(Found(target))
    }

    pub(crate) fn get(self) -> Target {
        self.0
    }
}

/// Instructions of [`Target::V3`], as a type.
#[cfg(target_arch = "x86_64")]
pub enum V3 {}

/// Instructions of [`Target::V4`], as a type.
#[cfg(target_arch = "x86_64")]
pub enum V4 {}
