//! The path of the core crate without its semicolon.

ga::define_algebra! {
    crate = ::ga::core
    mod wrong: R3 {}
}

fn main() {}
