//! A crate without the standard library, on the two crates that the macro needs.

#![no_std]
#![forbid(unsafe_code)]
#![deny(missing_docs, warnings)]

ga_macros::define_algebra!(R3);

/// Integers, which need no function of the standard library.
pub fn volume(a: r3::Vector<i64>, b: r3::Vector<i64>, c: r3::Vector<i64>) -> i64 {
    ((a ^ b) ^ c).e123
}

/// Exponential and norm, which do.
pub fn rotor(plane: r3::Bivector<f32>) -> (r3::Even<f32>, f32) {
    (plane.exp(), plane.norm())
}
