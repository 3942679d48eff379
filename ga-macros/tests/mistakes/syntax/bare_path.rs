//! A path to the core crate that is none.

ga::define_algebra! {
    crate = 5;
    R3
}

fn main() {}
