//! An identifier with two readings.

ga::define_algebra! {
    mod wrong: R12 {
        types { Plane { e112 } }
    }
}

fn main() {}
