//! A keyword as a basis vector.

ga::define_algebra! {
    mod wrong: R3 {
        basis { e1, fn, e3 }
    }
}

fn main() {}
