//! A semicolon after a list of blades.

ga::define_algebra! {
    mod wrong: R3 {
        types { Vector { e1, e2, e3 }; Plane { e12 } }
    }
}

fn main() {}
