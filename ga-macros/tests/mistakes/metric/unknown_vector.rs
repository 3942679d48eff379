//! An inner product with a vector that is not there.

ga::define_algebra! {
    mod wrong: R3 {
        metric { e1^2 = 1, e2^2 = 1, e3^2 = 1, e1.e9 = 0 }
    }
}

fn main() {}
