//! A misspelt section.

ga::define_algebra! {
    mod wrong: R3 {
        type { Vector { e1, e2, e3 } }
    }
}

fn main() {}
