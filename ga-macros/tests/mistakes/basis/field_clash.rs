//! Names that are the same when joined.

ga::define_algebra! {
    mod wrong: R3 {
        basis { x, x_, _x }
        types { Plane { x^_x, x_^x } }
    }
}

fn main() {}
