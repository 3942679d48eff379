//! A section among the types.

ga::define_algebra! {
    mod wrong: R3 {
        types {
            Vector { e1, e2, e3 }
            products { wedge }
        }
    }
}

fn main() {}
