//! An attribute without a type.

ga::define_algebra! {
    mod wrong: R3 {
        types { #[unit] }
    }
}

fn main() {}
