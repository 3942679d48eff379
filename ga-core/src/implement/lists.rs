//! Functions that differ only in the types they take: listed by pair instead of spelled out.

mod application;
mod conversions;
mod exponentials;
mod inverses;
mod logarithms;
mod products;
