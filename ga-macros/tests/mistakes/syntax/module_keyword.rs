//! A keyword as the name of the module.

ga::define_algebra! {
    mod fn: R3 {}
}

fn main() {}
