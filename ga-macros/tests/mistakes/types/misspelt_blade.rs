//! A misspelt blade.

ga::define_algebra! {
    mod wrong: R4_1 {
        basis { e1, e2, e3, origin, infinity }
        metric { e1^2 = 1, e2^2 = 1, e3^2 = 1, origin.infinity = -1 }
        types { Point { origin = 1, e1, e2, e3, infinty } }
    }
}

fn main() {}
