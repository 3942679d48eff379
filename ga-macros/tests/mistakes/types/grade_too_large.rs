//! A grade above the dimension.

ga::define_algebra! {
    mod wrong: R3 {
        types { Nonavector = grade 9; }
    }
}

fn main() {}
