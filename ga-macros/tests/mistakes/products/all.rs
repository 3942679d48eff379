//! A word for all products.

ga::define_algebra! {
    mod wrong: R3 {
        products { all }
    }
}

fn main() {}
