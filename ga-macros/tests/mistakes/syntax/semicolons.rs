//! Entries separated by semicolons.

ga::define_algebra! {
    mod wrong: R3 {
        basis { x; y; z }
        metric { x^2 = 1; y^2 = 1; z^2 = 1 }
    }
}

fn main() {}
