//! A range of names.

ga::define_algebra! {
    mod wrong: R3 {
        basis { e1..e3 }
    }
}

fn main() {}
