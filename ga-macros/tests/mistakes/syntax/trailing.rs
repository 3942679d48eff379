//! Two algebras in one call.

ga::define_algebra! {
    mod wrong: R3 {}
    mod other: R2 {}
}

fn main() {}
