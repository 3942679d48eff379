//! A standard type that would hold null elements only.

ga::define_algebra! {
    mod wrong: R2_1 {
        types { #[null] Even = even; }
    }
}

fn main() {}
