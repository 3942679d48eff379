//! The diagonal as a list of numbers.

ga::define_algebra! {
    mod wrong: R2 {
        metric { 1, 1 }
    }
}

fn main() {}
