//! A basis vector named twice.

ga::define_algebra! {
    mod wrong: R3 {
        basis { e1, e2, e1 }
    }
}

fn main() {}
