//! A count that no machine word holds.

ga::define_algebra!(R99999999999999999999);

fn main() {}
