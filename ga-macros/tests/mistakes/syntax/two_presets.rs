//! Two presets in one call.

ga::define_algebra!(R2; R3);

fn main() {}
