//! A type name that is not in camel case.

ga::define_algebra! {
    mod wrong: R3 {
        types { unit_vector { e1, e2, e3 } }
    }
}

fn main() {}
