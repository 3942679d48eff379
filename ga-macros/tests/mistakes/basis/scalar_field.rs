//! The name of the field of the scalar.

ga::define_algebra! {
    mod wrong: R3 {
        basis { e1, s, e3 }
    }
}

fn main() {}
