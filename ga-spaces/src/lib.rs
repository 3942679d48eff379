//! Ready algebras of other geometries than conformal 3-space, each with what it is for.
//!
//! | module | metric | what it is for |
//! |---|---|---|
//! | [`euclidean2`], [`euclidean3`] | R2, R3 | vectors, areas, rotations about the origin |
//! | [`plane_based2`], [`plane_based3`] | R2,0,1, R3,0,1 | rigid motions of flat elements |
//! | [`spacetime`] | R1,3 | boosts, velocities, electromagnetic fields |
//!
//! Everything here is made by the macro of `ga-macros` as any user could make it; the modules
//! add names, constructors and the few operations that an algebra needs to be used.

#![no_std]

pub mod euclidean2;
pub mod euclidean3;
pub mod plane_based2;
pub mod plane_based3;
pub mod spacetime;
