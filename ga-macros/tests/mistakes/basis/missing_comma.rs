//! Two names without a comma between.

ga::define_algebra! {
    mod wrong: R3 {
        basis { e1 e2, e3 }
    }
}

fn main() {}
