//! An attribute of the form that files have.

ga::define_algebra! {
    mod wrong: R3 {
        types {
            #![allow(dead_code)]
            Vector { e1, e2, e3 }
        }
    }
}

fn main() {}
