//! A fixed coefficient whose square nothing makes up for, in an oblique metric.

ga::define_algebra! {
    mod wrong: R2_1 {
        basis { x, y, t }
        metric { x^2 = 2, x.y = 1, y^2 = 1, t^2 = -1 }
        types {
            #[null] Event { t = 1, x, y }
            #[null] Place { x = 1, y }
        }
    }
}

fn main() {}
