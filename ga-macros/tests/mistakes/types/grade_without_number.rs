//! A grade without its number.

ga::define_algebra! {
    mod wrong: R3 {
        types { Vector = grade; }
    }
}

fn main() {}
