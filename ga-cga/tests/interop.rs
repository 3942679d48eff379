//! Other libraries agree on what points, rotations and motions do, and their traits work on the
//! conformal types.

#![forbid(unsafe_code)]

#[cfg(feature = "glam")]
#[path = "interop/glam.rs"]
mod glam;
#[cfg(feature = "mint")]
#[path = "interop/mint.rs"]
mod mint;
#[cfg(feature = "nalgebra")]
#[path = "interop/nalgebra.rs"]
mod nalgebra;
#[path = "interop/traits.rs"]
mod traits;
