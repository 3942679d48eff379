//! A path at which there is no core.

ga_macros::define_algebra! {
    crate = ::nowhere;
    R1
}

fn main() {}
