//! Batches of generated elements, computed in SIMD lanes chosen at run time.
//!
//! A [`Batch`] holds elements of one generated type coefficient by coefficient. Its operations are
//! those of the type, on all elements: with another batch element by element, or with [`One`]
//! element that meets every other. What has no value for some elements — logarithms, roots,
//! inverses — gives a [`Partial`] batch, an `Option` for each.
//!
//! ```
//! use ga_lanes::{Batch, One};
//! # ga_macros::define_algebra! { crate = ga_core; R3 }
//! use r3::{Bivector, Vector};
//!
//! let angles = [0.1, 0.2, 0.3];
//! let generators: Batch<Bivector> = angles.iter().map(|a| Bivector::new(-a / 2.0, 0.0, 0.0)).collect();
//! let rotors = generators.exp();
//! let images = rotors.apply(One(Vector::new(1.0, 0.0, 0.0)))?;
//! let angle = |x: Vector| x.e2.atan2(x.e1);
//! for (image, expected) in images.iter().zip(angles) {
//!     assert!((angle(image) - expected).abs() < 1e-12);
//! }
//! assert_eq!(rotors.log().all().map(|logarithms| logarithms.len()), Ok(3));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//! # How targets are chosen
//! Every operation is compiled for each [`Target`] — the vectors of the compiler's own target,
//! AVX2 with fused multiply-add, AVX-512 — and the widest that the machine has is found when the
//! program runs. [`Target::scope`] chooses another one for comparisons. A function of one's own
//! ([`Batch::map`], [`Batch::zip_map`]) or a whole [`Kernel`] is compiled and chosen the same way.
//! It has to be `#[inline(always)]`, with all it calls in its inner loop; generated functions are,
//! by the feature `inlined` of ga-core, in optimised builds.
//!
//! The portable target computes what single elements do, number for number, wherever the compiler
//! fuses neither; the others round a multiply-add once. What lies in one element never reaches
//! another one, except that general logarithms take as many halvings as the neighbour that takes
//! most, which changes roundings.
//!
//! # One on many
//! [`One`] element has the operations of a batch. One versor on many elements is fastest as a
//! matrix, which [`One::apply_linear`] builds once.
//!
//! # Elements in slices
//! For single elements and slices of them the compiler decides alone. The default x86-64 target
//! leaves fused multiply-add and wide vectors unused: build with
//! `RUSTFLAGS="-C target-cpu=x86-64-v3"`. The functions of [`slices`] compute slices in lanes
//! without that flag. [`Batch::from_slice`] and [`Batch::to_vec`] turn slices into batches and
//! back, which costs about as much as copying them twice; that pays where several operations follow
//! one another.
//!
//! # Limits
//! Exponentials, logarithms and roots by iteration, as in six dimensions, and inverses by recursion
//! over a whole algebra run in the portable lanes on every machine: they are too long to be inlined,
//! and in wider lanes each of their operations would be a call. A function of one's own that
//! contains one is slow for that reason.
//!
//! Numbers are `f32` and `f64`. In builds for debugging lanes are slower than single elements.
//! With the feature `rayon` batches of some thousand elements on are spread over all cores, with
//! the same results.
//!
//! # Unsafe code
//! This crate is the only one of the project with any, because the instructions of a target are
//! not safe to call where the compiler does not know the target, and operators on lanes are such a
//! place. It is in the operators on vectors, in the call of the function that is compiled for a
//! target, in the access to columns of whole cache lines and in their split between threads, and
//! in the transposing of [`slices`], each with its reason. Vectors cannot be had outside of a
//! kernel, and kernels run on targets that were found only.

mod batch;
mod dispatch;
mod lanes;
mod methods;
mod number;
mod operand;
mod operation;
mod partial;
pub mod slices;
mod target;
mod task;

pub use batch::Batch;
pub use dispatch::{Kernel, dispatch, dispatch_on};
pub use ga_core::LengthMismatch;
pub use lanes::Lanes;
pub use number::Number;
pub use operand::{One, Operand};
pub use operation::{Map, ZipMap};
pub use partial::Partial;
pub use target::Target;
