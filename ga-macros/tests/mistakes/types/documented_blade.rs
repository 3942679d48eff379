//! Documentation of one coefficient.

ga::define_algebra! {
    mod wrong: R3 {
        types {
            Vector {
                /// To the right.
                e1,
                e2,
            }
        }
    }
}

fn main() {}
