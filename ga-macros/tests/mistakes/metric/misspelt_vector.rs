//! A misspelt vector.

ga::define_algebra! {
    mod wrong: R3 {
        basis { alpha, beta, gamma }
        metric { alpha^2 = 1, betta^2 = 1, gamma^2 = 1 }
    }
}

fn main() {}
