//! A blade with a vector that is not there.

ga::define_algebra! {
    mod wrong: R3 {
        types { Rotor { 1, e12, e14 } }
    }
}

fn main() {}
