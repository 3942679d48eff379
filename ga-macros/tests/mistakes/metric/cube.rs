//! A power other than two.

ga::define_algebra! {
    mod wrong: R3 {
        metric { e1^3 = 1, e2^2 = 1, e3^2 = 1 }
    }
}

fn main() {}
