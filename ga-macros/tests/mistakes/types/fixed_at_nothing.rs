//! A fixed coefficient without its value.

ga::define_algebra! {
    mod wrong: R3 {
        types { Point { e1 = , e2 } }
    }
}

fn main() {}
