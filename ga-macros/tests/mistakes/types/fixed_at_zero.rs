//! A coefficient fixed at zero.

ga::define_algebra! {
    mod wrong: R3 {
        types { Vector { e1, e2, e3 = 0 } }
    }
}

fn main() {}
