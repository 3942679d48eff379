//! A signature that is a word.

ga::define_algebra!(Euclidean);

fn main() {}
