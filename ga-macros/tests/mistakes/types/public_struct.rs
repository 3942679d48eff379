//! A type declared as a struct.

ga::define_algebra! {
    mod wrong: R3 {
        types {
            pub Vector { e1, e2, e3 }
            struct Plane { e12, e23, e31 }
        }
    }
}

fn main() {}
