//! More dimensions than a preset has.

ga::define_algebra!(R9);

fn main() {}
