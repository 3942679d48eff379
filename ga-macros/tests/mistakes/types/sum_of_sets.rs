//! The sum of two sets.

ga::define_algebra! {
    mod wrong: R3 {
        types { Rotor = grade 0 + grade 2; }
    }
}

fn main() {}
