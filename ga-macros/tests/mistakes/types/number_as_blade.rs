//! A number other than one as the scalar.

ga::define_algebra! {
    mod wrong: R3 {
        types { Rotor { 2, e12 } }
    }
}

fn main() {}
