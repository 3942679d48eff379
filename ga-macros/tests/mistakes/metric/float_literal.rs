//! A number with a type.

ga::define_algebra! {
    mod wrong: R1 {
        metric { e1^2 = 1.0f64 }
    }
}

fn main() {}
