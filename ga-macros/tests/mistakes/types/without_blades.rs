//! A type that does not say what it holds.

ga::define_algebra! {
    mod wrong: R3 {
        types { Vector; }
    }
}

fn main() {}
