//! A power of a vector as a blade.

ga::define_algebra! {
    mod wrong: R3 {
        types { Plane { e1^2, e12 } }
    }
}

fn main() {}
