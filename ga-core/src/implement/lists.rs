//! Functions that differ only in the types they take: listed by pair instead of spelled out.

mod application;
mod conversions;
mod exponentials;
mod inverses;
mod kernels;
mod linear_maps;
mod logarithms;
mod products;
