//! A coefficient fixed twice.

ga::define_algebra! {
    mod wrong: R3 {
        types { Point { e1, e2, e3 = 1, e3 = 2 } }
    }
}

fn main() {}
