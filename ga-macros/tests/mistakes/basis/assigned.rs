//! A basis vector with a value, which belongs to the metric.

ga::define_algebra! {
    mod wrong: R3 {
        basis { e1 = 1, e2, e3 }
    }
}

fn main() {}
