//! `#[unit]` with something in it.

ga::define_algebra! {
    mod wrong: R3 {
        types { #[unit(true)] Rotor = even; }
    }
}

fn main() {}
