//! A set without its semicolon.

ga::define_algebra! {
    mod wrong: R3 {
        types {
            Vector = grade 1
            Plane = grade 2;
        }
    }
}

fn main() {}
