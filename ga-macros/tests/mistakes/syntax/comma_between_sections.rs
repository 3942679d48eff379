//! A comma between sections.

ga::define_algebra! {
    mod wrong: R3 {
        basis { x, y, z },
        types { Vector { x, y, z } }
    }
}

fn main() {}
