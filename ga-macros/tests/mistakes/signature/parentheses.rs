//! A signature in the notation of papers.

ga::define_algebra!(Cl(4, 1));

fn main() {}
