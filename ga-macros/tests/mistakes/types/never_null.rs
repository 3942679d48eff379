//! Null elements of a definite metric.

ga::define_algebra! {
    mod wrong: R3 {
        types { #[null] Direction { e1, e2, e3 } }
    }
}

fn main() {}
