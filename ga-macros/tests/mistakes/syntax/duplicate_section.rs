//! A section twice.

ga::define_algebra! {
    mod wrong: R3 {
        products { wedge }
        products { inner }
    }
}

fn main() {}
