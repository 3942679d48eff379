//! A grade by a word.

ga::define_algebra! {
    mod wrong: R3 {
        types { Vector = grade one; }
    }
}

fn main() {}
