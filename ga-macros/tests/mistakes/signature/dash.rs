//! A signature with a dash.

ga::define_algebra!(R4-1);

fn main() {}
