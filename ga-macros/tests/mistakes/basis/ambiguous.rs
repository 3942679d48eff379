//! A basis vector that reads as a blade of the others.

ga::define_algebra! {
    mod wrong: R3 {
        basis { e1, e2, e12 }
    }
}

fn main() {}
