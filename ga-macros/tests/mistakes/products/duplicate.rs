//! A product listed twice.

ga::define_algebra! {
    mod wrong: R3 {
        products { wedge, inner, wedge }
    }
}

fn main() {}
