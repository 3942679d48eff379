//! A name that the generated code uses.

ga::define_algebra! {
    mod wrong: R3 {
        types { Blade { e1 } }
    }
}

fn main() {}
