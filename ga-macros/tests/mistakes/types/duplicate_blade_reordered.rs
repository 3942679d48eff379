//! A blade again with the other sign.

ga::define_algebra! {
    mod wrong: R3 {
        types { Plane { e12, e23, e2^e1 } }
    }
}

fn main() {}
