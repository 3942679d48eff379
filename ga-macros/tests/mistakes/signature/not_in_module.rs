//! A module without a signature.

ga::define_algebra! {
    mod wrong {
        types { Vector { e1, e2, e3 } }
    }
}

fn main() {}
