//! A type of one value.

ga::define_algebra! {
    mod wrong: R3 {
        types { Origin { e1 = 1, e2 = 1 } }
    }
}

fn main() {}
