//! No type for the sums of points.

ga::define_algebra! {
    mod wrong: R9 {
        types { Point { e1, e2, e9 = 1 } }
    }
}

fn main() {}
