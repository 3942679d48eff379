//! A set by the name of its elements.

ga::define_algebra! {
    mod wrong: R3 {
        types { Line = bivector; }
    }
}

fn main() {}
