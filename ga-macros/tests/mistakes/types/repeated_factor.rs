//! A vector twice in one blade.

ga::define_algebra! {
    mod wrong: R3 {
        types { Plane { e1^e1 } }
    }
}

fn main() {}
