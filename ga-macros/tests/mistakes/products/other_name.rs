//! A product by the name it has elsewhere.

ga::define_algebra! {
    mod wrong: R3 {
        products { outer }
    }
}

fn main() {}
