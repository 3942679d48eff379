//! An algebra declared as something other than a module.

ga::define_algebra! {
    struct wrong: R3 {
        types { Vector { e1, e2, e3 } }
    }
}

fn main() {}
