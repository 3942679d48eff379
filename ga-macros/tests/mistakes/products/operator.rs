//! A product by its operator.

ga::define_algebra! {
    mod wrong: R3 {
        products { ^, inner }
    }
}

fn main() {}
