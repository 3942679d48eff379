//! The name of the type parameter.

ga::define_algebra! {
    mod wrong: R3 {
        types { T { e1, e2, e3 } }
    }
}

fn main() {}
