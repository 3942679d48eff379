//! Two values for one entry.

ga::define_algebra! {
    mod wrong: R3 {
        metric { e1^2 = 1, e2^2 = 1, e3^2 = 1, e1.e2 = 1/2, e2.e1 = 1/3 }
    }
}

fn main() {}
