//! Fewer names than vectors.

ga::define_algebra! {
    mod wrong: R3 {
        basis { e1, e2 }
    }
}

fn main() {}
