//! A number beyond exact arithmetic.

ga::define_algebra! {
    mod wrong: R3 {
        metric { e1^2 = 123456789012, e2^2 = 1, e3^2 = 1 }
    }
}

fn main() {}
