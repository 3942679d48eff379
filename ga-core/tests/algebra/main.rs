//! The tests of ga-core: exact laws, two implementations against each other, answers of
//! independent programs, and the numbers.

#![cfg(any(feature = "std", feature = "libm"))]

mod catalogue;
mod dense_failures;
mod elementary;
mod exponential;
mod golden;
mod laws;
mod metrics;
mod numbers;
mod oracle;
mod tables;
