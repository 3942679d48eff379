//! Something other than a section.

ga::define_algebra! {
    mod wrong: R3 {
        "R3"
    }
}

fn main() {}
