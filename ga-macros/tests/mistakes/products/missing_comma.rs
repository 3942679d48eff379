//! Two products without a comma between.

ga::define_algebra! {
    mod wrong: R3 {
        products { wedge inner }
    }
}

fn main() {}
