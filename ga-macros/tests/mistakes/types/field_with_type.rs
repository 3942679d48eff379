//! Coefficients declared as fields.

ga::define_algebra! {
    mod wrong: R3 {
        types { Vector { e1: f64, e2: f64 } }
    }
}

fn main() {}
