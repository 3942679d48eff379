//! A vector left out of the basis is not reported again where types use it.

ga::define_algebra! {
    mod wrong: R3 {
        basis { e1, e2 }
        types {
            Vector { e1, e2, e3 }
            Volume = grade 3;
        }
    }
}

fn main() {}
