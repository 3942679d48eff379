//! A number as a basis vector.

ga::define_algebra! {
    mod wrong: R3 {
        basis { e1, 2, e3 }
    }
}

fn main() {}
