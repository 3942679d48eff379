//! The null vector by the name it has elsewhere.

ga::define_algebra! {
    mod wrong: R2_0_1 {
        types { Line { e1, e2, e0 } }
    }
}

fn main() {}
