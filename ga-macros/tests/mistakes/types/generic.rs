//! A type with parameters.

ga::define_algebra! {
    mod wrong: R3 {
        types { Vector<T> { e1, e2, e3 } }
    }
}

fn main() {}
