//! A number that is not rational.

ga::define_algebra! {
    mod wrong: R3 {
        metric { e1^2 = sqrt(2), e2^2 = 1, e3^2 = 1 }
    }
}

fn main() {}
