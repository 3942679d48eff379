//! A count with a sign.

ga::define_algebra!(R3_-1);

fn main() {}
