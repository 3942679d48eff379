//! A signature with four counts.

ga::define_algebra!(R1_2_3_4);

fn main() {}
