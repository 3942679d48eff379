//! A blade twice in one type.

ga::define_algebra! {
    mod wrong: R3 {
        types { Plane { e12, e23, e12 } }
    }
}

fn main() {}
