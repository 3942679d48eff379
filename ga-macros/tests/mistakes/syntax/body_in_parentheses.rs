//! Sections in parentheses.

ga::define_algebra! {
    mod wrong: R3 (
        types { Vector { e1, e2, e3 } }
    )
}

fn main() {}
