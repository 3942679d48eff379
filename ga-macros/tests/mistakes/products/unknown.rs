//! A product that does not exist.

ga::define_algebra! {
    mod wrong: R3 {
        products { cross_ratio }
    }
}

fn main() {}
