//! A type name that is no name.

ga::define_algebra! {
    mod wrong: R3 {
        types { 3Vector { e1, e2, e3 } }
    }
}

fn main() {}
