//! The name of the type parameter of every type.

ga::define_algebra! {
    mod wrong: R3 {
        basis { T, X, Y }
    }
}

fn main() {}
