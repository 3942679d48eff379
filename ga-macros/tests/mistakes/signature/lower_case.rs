//! A signature in lower case.

ga::define_algebra!(r3);

fn main() {}
