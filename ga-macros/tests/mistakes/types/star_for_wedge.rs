//! The vectors of a blade joined by another product.

ga::define_algebra! {
    mod wrong: R3 {
        types { Plane { e1*e2, e23 } }
    }
}

fn main() {}
