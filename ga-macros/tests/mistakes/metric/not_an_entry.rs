//! An entry that is neither a square nor a product.

ga::define_algebra! {
    mod wrong: R3 {
        metric { e1 = 1, e2^2 = 1, e3^2 = 1 }
    }
}

fn main() {}
