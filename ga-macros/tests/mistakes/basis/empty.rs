//! An empty basis.

ga::define_algebra! {
    mod wrong: R1 {
        basis {}
    }
}

fn main() {}
