//! A misspelt set of blades.

ga::define_algebra! {
    mod wrong: R3 {
        types { Rotor = evn; }
    }
}

fn main() {}
