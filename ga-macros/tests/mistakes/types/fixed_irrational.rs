//! A fixed value that is not rational.

ga::define_algebra! {
    mod wrong: R3 {
        types { Vector { e1, e2, e3 = pi } }
    }
}

fn main() {}
