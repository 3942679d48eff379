//! Two signatures in one call.

ga::define_algebra!(R3, R4_1);

fn main() {}
