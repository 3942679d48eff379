//! A section that does not exist.

ga::define_algebra! {
    mod wrong: R3 {
        geometry { sphere }
    }
}

fn main() {}
