//! Vectors that no basis names.

ga::define_algebra! {
    mod wrong: R1_1 {
        metric { no.ni = -1 }
    }
}

fn main() {}
