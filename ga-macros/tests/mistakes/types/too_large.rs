//! More fields than a type can have.

ga::define_algebra! {
    mod wrong: R12 {
        types { Everything = all; }
    }
}

fn main() {}
