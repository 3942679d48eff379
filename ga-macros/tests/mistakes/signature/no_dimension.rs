//! No basis vector at all.

ga::define_algebra!(R0_0);

fn main() {}
