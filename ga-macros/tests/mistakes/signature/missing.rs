//! An empty call.

ga::define_algebra!();

fn main() {}
