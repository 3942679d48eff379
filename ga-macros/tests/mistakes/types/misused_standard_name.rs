//! A standard name for other blades.

ga::define_algebra! {
    mod wrong: R3 {
        types { Even { 1, e12 } }
    }
}

fn main() {}
