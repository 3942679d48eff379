//! An attribute that a type cannot have.

ga::define_algebra! {
    mod wrong: R3 {
        types { #[derive(Hash)] Vector { e1, e2, e3 } }
    }
}

fn main() {}
