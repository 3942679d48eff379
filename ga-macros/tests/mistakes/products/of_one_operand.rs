//! An involution among the products.

ga::define_algebra! {
    mod wrong: R3 {
        products { geometric, reverse }
    }
}

fn main() {}
