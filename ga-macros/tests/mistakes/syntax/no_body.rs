//! A module without a body.

ga::define_algebra! {
    mod wrong: R3
}

fn main() {}
