//! Ready algebras of other geometries than conformal 3-space, each with what it is for.
//!
//! | module | metric | what it is for | feature |
//! |---|---|---|---|
//! | `euclidean2`, `euclidean3` | R2, R3 | vectors, areas, rotations about the origin | `euclidean` |
//! | `plane_based2`, `plane_based3` | R2,0,1, R3,0,1 | planes, lines, points and rigid motions | `plane-based` |
//! | `spacetime` | R1,3 | boosts, velocities, electromagnetic fields | `spacetime` |
//! | `conformal2` | R3,1 | circles, Möbius transformations of the plane | `conformal-plane` |
//! | `conformal` | Rn+1,1, n = 1 … 5 | code for points and spheres of any dimension | `conformal` |
//! | `conformal_spacetime` | R2,4 | events, light cones, what keeps light light | `conformal-spacetime` |
//! | `lie_sphere` | R4,2 | oriented spheres and planes in contact | `lie-sphere` |
//! | `projective3` | R3,3 | lines, projective transformations | `projective` |
//!
//! The first four features are on by default; `all` is all of them. The algebras of six and more
//! dimensions take seconds to compile, so each is asked for by name.
//!
//! Everything here is made by the macro of `ga-macros` as any user could make it; the modules
//! add names, constructors and the few operations that an algebra needs to be used. Real
//! functions need the feature `std` or `libm`.

#![no_std]

pub use ga_core::Unit;

#[cfg(feature = "conformal")]
pub mod conformal;
#[cfg(feature = "conformal-plane")]
pub mod conformal2;
#[cfg(feature = "conformal-spacetime")]
pub mod conformal_spacetime;
#[cfg(feature = "euclidean")]
pub mod euclidean2;
#[cfg(feature = "euclidean")]
pub mod euclidean3;
#[cfg(feature = "lie-sphere")]
pub mod lie_sphere;
#[cfg(feature = "plane-based")]
pub mod plane_based2;
#[cfg(feature = "plane-based")]
pub mod plane_based3;
#[cfg(feature = "projective")]
pub mod projective3;
#[cfg(feature = "spacetime")]
pub mod spacetime;
