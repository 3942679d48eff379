//! A misspelt product.

ga::define_algebra! {
    mod wrong: R3 {
        products { geometrc }
    }
}

fn main() {}
