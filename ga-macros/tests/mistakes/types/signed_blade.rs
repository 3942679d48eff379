//! A sign in front of a blade.

ga::define_algebra! {
    mod wrong: R3 {
        types { Plane { e12, e23, -e13 } }
    }
}

fn main() {}
