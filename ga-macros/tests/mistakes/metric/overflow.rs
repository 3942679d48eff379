//! Entries whose products leave exact arithmetic.

ga::define_algebra! {
    mod wrong: R8 {
        metric {
            e1^2 = 1/999983, e2^2 = 1/999979, e3^2 = 1/999961, e4^2 = 1/999959, e5^2 = 1/999953,
            e6^2 = 1/999931, e7^2 = 1/999917, e8^2 = 1/999907, e1.e2 = 1/999883,
        }
    }
}

fn main() {}
