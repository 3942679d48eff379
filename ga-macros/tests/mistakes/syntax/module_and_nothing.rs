//! A module with neither signature nor body.

ga::define_algebra! {
    mod wrong
}

fn main() {}
