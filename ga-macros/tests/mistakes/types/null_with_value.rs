//! `#[null]` with something in it.

ga::define_algebra! {
    mod wrong: R3_1 {
        types { #[null = true] Ray = grade 1; }
    }
}

fn main() {}
