//! A square given again as a product, with another value.

ga::define_algebra! {
    mod wrong: R3 {
        metric { e1^2 = 1, e2^2 = 1, e3^2 = 1, e1.e1 = 2 }
    }
}

fn main() {}
