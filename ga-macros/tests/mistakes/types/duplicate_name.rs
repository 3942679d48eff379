//! A type name twice.

ga::define_algebra! {
    mod wrong: R3 {
        types {
            Line { e1 }
            Line { e2 }
        }
    }
}

fn main() {}
