//! A section assigned to.

ga::define_algebra! {
    mod wrong: R3 {
        basis = { x, y, z }
    }
}

fn main() {}
